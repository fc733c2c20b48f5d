#include "shared/physics/region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "platon/exact/integer.h"
#include "tests/sim/seeded_random.h"

namespace platon {
namespace {

constexpr std::uint64_t kSeed = 808;

MapGeometry randomPart(std::uint32_t id, std::size_t lines) {
  sim::SeededRandom random(kSeed + id);
  MapGeometry part;
  part.id = id;
  for (std::size_t i = 0; i < lines; ++i) {
    const Point a = random.vector(1 << 20);
    part.segments.push_back({a, a + random.vector(1 << 14)});
  }
  part.grid = Grid(part.segments);
  return part;
}

void expectCovers(const Region& region, const MapGeometry& part, const Box& box) {
  const auto& lines = region.segments();
  ASSERT_TRUE(std::is_sorted(lines.begin(), lines.end()));
  ASSERT_EQ(std::adjacent_find(lines.begin(), lines.end()), lines.end());
  for (std::uint32_t i = 0; i < part.segments.size(); ++i) {
    if (!box.overlaps(boundsOf(part.segments[i]))) continue;
    std::vector<std::uint32_t> queried;
    part.grid.query(box, queried);
    if (!std::binary_search(queried.begin(), queried.end(), i)) continue;
    ASSERT_TRUE(std::binary_search(lines.begin(), lines.end(), i)) << "seed " << kSeed << ", line " << i;
  }
}

TEST(RegionTest, IsEmptyAtFirst) { EXPECT_TRUE(Region().segments().empty()); }

TEST(RegionTest, CoversEveryQueriedBox) {
  const MapGeometry part = randomPart(1, 2000);
  sim::SeededRandom random(kSeed);
  Region region;
  Point at;
  for (int i = 0; i < 2000; ++i) {
    at += random.vector(i % 50 == 0 ? 1 << 18 : 20000);
    if (std::abs(at.x) > 1 << 21 || std::abs(at.y) > 1 << 21) at = Point();
    const Box box{at - Point(12000, 12000), at + Point(12000, 12000)};
    region.cover(part, box);
    ASSERT_NO_FATAL_FAILURE(expectCovers(region, part, box)) << i;
  }
}

TEST(RegionTest, RefillsForAnotherPart) {
  const MapGeometry first = randomPart(1, 500);
  const MapGeometry second = randomPart(2, 500);
  Region region;
  const Box box{{-100000, -100000}, {100000, 100000}};
  for (int i = 0; i < 4; ++i) {
    const MapGeometry& part = i % 2 == 0 ? first : second;
    region.cover(part, box);
    ASSERT_NO_FATAL_FAILURE(expectCovers(region, part, box));
  }
}

TEST(RegionTest, ReachesBeyondTheCoordinates) {
  MapGeometry part;
  constexpr std::int32_t largest = kCoordinateLimit - 1;
  part.segments = {
      {{-largest, -largest}, {-largest, largest}}, {{largest, -largest}, {largest, largest}}, {{0, 0}, {0, 0}}};
  part.grid = Grid(part.segments);
  Region region;
  region.cover(part, {{largest - 5, -7}, {2 * largest, 2 * largest}});
  expectCovers(region, part, {{largest - 5, -7}, {largest, largest}});
  region.cover(part, {{-2 * largest, -2 * largest}, {2 * largest, 2 * largest}});
  EXPECT_EQ(region.segments().size(), 3u);
}

}  // namespace
}  // namespace platon
