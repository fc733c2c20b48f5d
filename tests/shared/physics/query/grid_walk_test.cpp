#include "shared/physics/query/grid_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/sim/seeded_random.h"

namespace platon::grid_walk_test {
namespace {

constexpr std::uint64_t kSeed = 5;

std::vector<Segment> randomSegments(sim::SeededRandom& random, std::int32_t scale, std::uint64_t count) {
  std::vector<Segment> segments;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Point a = random.vector(scale);
    segments.push_back({a, i % 5 == 0 ? random.vector(scale) : a + random.vector(scale / 8 + 1)});
  }
  return segments;
}

// The box at the start, at the end and at 16 places between, rounded.
std::vector<Box> placesOf(const Box& extent, Point from, Point displacement) {
  std::vector<Box> places;
  for (std::int32_t i = 0; i <= 16; ++i) {
    const Point at = from + Point(displacement.x * i / 16, displacement.y * i / 16);
    places.push_back({at + extent.low, at + extent.high});
  }
  return places;
}

TEST(GridWalkTest, FindsEverySegmentThatTheMovingBoxTouches) {
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 2000; ++round) {
    const std::int32_t scale = round % 2 == 0 ? 30 : 5000;
    const auto segments = randomSegments(random, scale, 1 + random.below(300));
    const Grid grid(segments);
    const Point low = random.vector(scale / 4);
    const Point size = random.vector(scale / 4);
    const Box extent{low, low + Point(std::abs(size.x), std::abs(size.y))};
    const Point from = random.vector(scale);
    // A multiple of 16, so that the places between are not rounded.
    const Point step = random.vector(scale / 8);
    const Point displacement(step.x * 16, round % 5 == 0 ? 0 : step.y * 16);
    std::vector<bool> walked(segments.size());
    for (GridWalk walk(grid, extent, from, displacement); !walk.isDone(); walk.next()) {
      for (const std::uint32_t index : walk.segments()) walked[index] = true;
    }
    for (const Box& box : placesOf(extent, from, displacement)) {
      for (std::size_t i = 0; i < segments.size(); ++i) {
        ASSERT_TRUE(walked[i] || !touches(segments[i], box)) << "seed " << kSeed << ", round " << round;
      }
    }
  }
}

// What is not found by the time at which a row is reached is touched at that time or later.
TEST(GridWalkTest, RowsAreReachedInTheOrderOfTime) {
  sim::SeededRandom random(kSeed);
  for (int round = 0; round < 500; ++round) {
    const auto segments = randomSegments(random, 3000, 200);
    const Grid grid(segments);
    const Box extent{{-40, -70}, {10, 30}};
    const Point from = random.vector(3000);
    const Point step = random.vector(300);
    const Point displacement(step.x * 16, step.y * 16);
    const auto places = placesOf(extent, from, displacement);
    std::vector<bool> walked(segments.size());
    Fraction last{0, 1};
    for (GridWalk walk(grid, extent, from, displacement); !walk.isDone(); walk.next()) {
      ASSERT_LE(last, walk.reached());
      last = walk.reached();
      for (std::int32_t i = 0; i <= 16; ++i) {
        if (!(Fraction{i, 16} < last)) break;
        for (std::size_t k = 0; k < segments.size(); ++k) {
          ASSERT_TRUE(walked[k] || !touches(segments[k], places[static_cast<std::size_t>(i)])) << "round " << round;
        }
      }
      for (const std::uint32_t index : walk.segments()) walked[index] = true;
    }
  }
}

TEST(GridWalkTest, ALongRayVisitsFewOfManySegments) {
  sim::SeededRandom random(kSeed);
  std::vector<Segment> segments;
  for (int i = 0; i < 100000; ++i) {
    const Point a = random.vector(1 << 24);
    segments.push_back({a, a + random.vector(20000)});
  }
  const Grid grid(segments);
  std::size_t visited = 0;
  for (GridWalk walk(grid, {}, {-(1 << 23), -(1 << 23)}, {1 << 24, 1 << 24}); !walk.isDone(); walk.next()) {
    visited += walk.segments().size();
  }
  EXPECT_LT(visited, 5000u);
  EXPECT_GT(visited, 100u);
}

TEST(GridWalkTest, AnEmptyGridHasNoRows) { EXPECT_TRUE(GridWalk(Grid(), {}, {}, {5, 5}).isDone()); }

}  // namespace
}  // namespace platon::grid_walk_test
