#include "platon/physics/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "platon/exact/integer.h"
#include "tests/sim/seeded_random.h"

namespace platon::grid_test {
namespace {

constexpr std::uint64_t kSeed = 5150;
constexpr std::int32_t kMax = kCoordinateLimit - 1;

using Lines = std::vector<Segment>;

struct Kind {
  const char* name;
  std::int32_t extent;
  std::function<Segment(sim::SeededRandom&, std::size_t)> make;
};

Point anywhere(sim::SeededRandom& random, std::int32_t extent) { return random.vector(extent); }

// Distributions of segments: typical levels and worst cases of the grid.
const std::vector<Kind>& kinds() {
  constexpr std::int32_t wide = 1 << 26;
  static const std::vector<Kind> all = {
      {"short", wide,
       [](auto& random, std::size_t) {
         const Point a = anywhere(random, wide - 5000);
         return Segment{a, a + random.vector(5000)};
       }},
      {"long", wide,
       [](auto& random, std::size_t) {
         return Segment{anywhere(random, wide), anywhere(random, wide)};
       }},
      {"diagonals", wide,
       [](auto&, std::size_t i) {
         const auto shift = static_cast<std::int32_t>(i) * 3;
         return Segment{{-wide + shift, -wide}, {wide, wide - shift}};
       }},
      {"clustered", wide,
       [](auto& random, std::size_t i) {
         const Point middle = i % 10 == 0 ? anywhere(random, wide - 300) : Point(1000, 1000);
         return Segment{middle + random.vector(300), middle + random.vector(300)};
       }},
      {"axis", wide,
       [](auto& random, std::size_t i) {
         const Point a = anywhere(random, wide);
         return i % 2 == 0 ? Segment{a, {-a.x, a.y}} : Segment{a, {a.x, -a.y}};
       }},
      {"points", 200,
       [](auto& random, std::size_t) {
         const Point a = anywhere(random, 200);
         return Segment{a, a};
       }},
      {"one line", 100,
       [](auto&, std::size_t) {
         return Segment{{-70, -30}, {90, 50}};
       }},
      {"staircase", wide,
       [](auto&, std::size_t i) {
         const auto at = static_cast<std::int32_t>(i / 2) * 100 - (1 << 23);
         return i % 2 == 0 ? Segment{{at, at}, {at + 100, at}} : Segment{{at + 100, at}, {at + 100, at + 100}};
       }},
      {"largest", kMax,
       [](auto& random, std::size_t) {
         const Point a = anywhere(random, kMax / 2);
         return Segment{{a.x < 0 ? -kMax : kMax, a.y * 2}, {a.y * 2, a.x < 0 ? kMax : -kMax}};
       }},
  };
  return all;
}

Lines linesOf(const Kind& kind, std::size_t count) {
  sim::SeededRandom random(kSeed);
  Lines lines;
  for (std::size_t i = 0; i < count; ++i) lines.push_back(kind.make(random, i));
  return lines;
}

// Exact test: the bounding boxes overlap, and the corners of the box are not all on one side of the segment.
bool meets(const Segment& line, const Box& box) {
  if (!box.overlaps(boundsOf(line))) return false;
  if (line.a == line.b) return true;
  int left = 0;
  int right = 0;
  for (const Point corner : {box.low, box.high, Point(box.low.x, box.high.y), Point(box.high.x, box.low.y)}) {
    const auto side = int128{line.b.x - line.a.x} * (std::int64_t{corner.y} - line.a.y) -
                      int128{line.b.y - line.a.y} * (std::int64_t{corner.x} - line.a.x);
    left += side > 0;
    right += side < 0;
  }
  return left != 4 && right != 4;
}

void expectComplete(const Grid& grid, const Lines& lines, const Box& box, const std::string& what) {
  std::vector<std::uint32_t> found;
  grid.query(box, found);
  ASSERT_TRUE(std::is_sorted(found.begin(), found.end())) << what;
  ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << what << ": each once";
  ASSERT_TRUE(found.empty() || found.back() < lines.size()) << what;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (!meets(lines[i], box)) continue;
    ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i)) << what << ": line " << i;
  }
}

TEST(GridTest, FindsNothingWithoutSegments) {
  std::vector<std::uint32_t> found{7};
  Grid().query({{-kMax, -kMax}, {kMax, kMax}}, found);
  Grid(Lines{}).query({{-kMax, -kMax}, {kMax, kMax}}, found);
  EXPECT_EQ(found, std::vector<std::uint32_t>{7});
}

TEST(GridTest, AppendsToTheResult) {
  const Lines lines{{{0, 0}, {10, 0}}, {{0, 5}, {10, 5}}};
  std::vector<std::uint32_t> found{9, 1};
  Grid(lines).query({{0, 0}, {10, 10}}, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{9, 1, 0, 1}));
}

TEST(GridTest, FindsEverySegmentThatTouchesTheBox) {
  for (const Kind& kind : kinds()) {
    for (const std::size_t count : {1u, 2u, 3u, 17u, 300u, 2000u}) {
      const Lines lines = linesOf(kind, count);
      const Grid grid(lines);
      sim::SeededRandom random(kSeed + count);
      for (int i = 0; i < 150; ++i) {
        const Point low = anywhere(random, kind.extent);
        const Point size = random.vector(1 + kind.extent / (1 << (i % 24)));
        Box box{low, {low.x + std::abs(size.x), low.y + std::abs(size.y)}};
        if (i % 3 == 0) box = boundsOf(lines[random.below(count)]);  // ends on borders of cells
        if (i % 5 == 0) box.high = box.low;
        ASSERT_NO_FATAL_FAILURE(expectComplete(
            grid, lines, box,
            std::string(kind.name) + ", " + std::to_string(count) + " lines, seed " + std::to_string(kSeed)));
      }
    }
  }
}

TEST(GridTest, FindsAllSegmentsInTheWholePlane) {
  for (const Kind& kind : kinds()) {
    const Lines lines = linesOf(kind, 500);
    std::vector<std::uint32_t> found;
    Grid(lines).query({{-kMax - 1, -kMax - 1}, {kMax + 1, kMax + 1}}, found);
    EXPECT_EQ(found.size(), lines.size()) << kind.name;
  }
}

TEST(GridTest, SmallBoxesFindFewShortSegments) {
  const Lines lines = linesOf(kinds()[0], 10000);
  const Grid grid(lines);
  sim::SeededRandom random(kSeed);
  std::size_t all = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point low = random.vector(1 << 25);
    std::vector<std::uint32_t> found;
    grid.query({low, low + Point(20000, 20000)}, found);
    all += found.size();
  }
  EXPECT_LT(all, 1000 * 40u) << "of 10000 lines each";
}

TEST(GridTest, UsesAtMost64BytesPerSegment) {
  for (const Kind& kind : kinds()) {
    for (const std::size_t count : {1000u, 10000u, 100000u}) {
      const Grid grid(linesOf(kind, count));
      EXPECT_LE(grid.bytes() + count * sizeof(Segment), 64 * count) << kind.name << ", " << count;
    }
  }
}

}  // namespace
}  // namespace platon::grid_test
