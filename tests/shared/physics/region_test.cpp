#include "shared/physics/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "platon/exact/integer.h"
#include "shared/physics/tolerances.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::region_test {
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
    if (!touches(part.segments[i], box)) continue;
    ASSERT_TRUE(std::binary_search(lines.begin(), lines.end(), i)) << "seed " << kSeed << ", line " << i;
  }
}

// `lines` points within a square of the given half side.
MapGeometry crowdedPart(std::size_t lines, std::int32_t reach) {
  sim::SeededRandom random(kSeed);
  MapGeometry part;
  part.id = 1;
  for (std::size_t i = 0; i < lines; ++i) {
    const Point at = random.vector(reach);
    part.segments.push_back({at, i % 3 == 0 ? at : at + random.vector(900)});
  }
  part.grid = Grid(part.segments);
  return part;
}

TEST(RegionTest, IsEmptyAtFirst) { EXPECT_TRUE(Region().segments().empty()); }

TEST(RegionTest, CoversEveryQueriedBox) {
  const MapGeometry part = randomPart(1, 2000);
  sim::SeededRandom random(kSeed);
  Region region;
  Region::Work work;
  Point at;
  for (int i = 0; i < 2000; ++i) {
    at += random.vector(i % 50 == 0 ? 1 << 18 : 20000);
    if (std::abs(at.x) > 1 << 21 || std::abs(at.y) > 1 << 21) at = Point();
    const Box box{at - Point(12000, 12000), at + Point(12000, 12000)};
    region.cover(part, box, work);
    ASSERT_NO_FATAL_FAILURE(expectCovers(region, part, box)) << i;
  }
}

TEST(RegionTest, RefillsForAnotherPart) {
  const MapGeometry first = randomPart(1, 500);
  const MapGeometry second = randomPart(2, 500);
  Region region;
  Region::Work work;
  const Box box{{-100000, -100000}, {100000, 100000}};
  for (int i = 0; i < 4; ++i) {
    const MapGeometry& part = i % 2 == 0 ? first : second;
    region.cover(part, box, work);
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
  Region::Work work;
  region.cover(part, {{largest - 5, -7}, {2 * largest, 2 * largest}}, work);
  expectCovers(region, part, {{largest - 5, -7}, {largest, largest}});
  region.cover(part, {{-2 * largest, -2 * largest}, {2 * largest, 2 * largest}}, work);
  EXPECT_EQ(region.segments().size(), 3u);
}

TEST(RegionTest, ACrowdedRegionCoversLittleMoreThanItMust) {
  const Box box{{-12000, -12000}, {12000, 12000}};
  Region::Work work;
  Region roomy;
  const MapGeometry sparse = crowdedPart(Region::kManySegments, 100000);
  roomy.cover(sparse, box, work);
  ASSERT_NO_FATAL_FAILURE(expectCovers(roomy, sparse, box.grown(12000)));
  Region tight;
  const MapGeometry dense = crowdedPart(20 * Region::kManySegments, 100000);
  tight.cover(dense, box, work);
  ASSERT_NO_FATAL_FAILURE(expectCovers(tight, dense, box.grown(3000)));
  for (const std::uint32_t line : tight.segments()) EXPECT_TRUE(touches(dense.segments[line], box.grown(3000))) << line;
}

// Whether an obstacle is kept or not, and after shapes were forgotten.
TEST(RegionTest, ClipsIdealPathsLikeTheObstacleAlone) {
  const MapGeometry part = crowdedPart(4000, 60000);
  const Convex shape({{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}});
  sim::SeededRandom random(kSeed);
  Region region;
  Region::Work work;
  Sweep sweep;
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    if (i % 50 == 49) region.forgetShape();
    const Point start = random.vector(i % 5 == 0 ? 40000 : 3000);
    const Point moved = random.vector(i % 2 == 0 ? 5000 : 50);
    const PrecisePoint from = precise(start) + PrecisePoint{random.vector(1 << 29).x, random.vector(1 << 29).y};
    sweep.start(shape, start, moved, Tolerances::kNear);
    region.cover(part, sweep.bounds(), work);
    for (std::size_t entry = 0; entry < region.segments().size(); ++entry) {
      const auto expected = clipIdeal(shape, part.segments[region.segments()[entry]], from, precise(moved));
      const bool mayOverlap = region.mayOverlap(sweep, entry, shape);
      ASSERT_TRUE(mayOverlap || !expected) << "seed " << kSeed << ", path " << i;
      if (!mayOverlap) continue;
      const auto entered = region.clipIdeal(sweep, entry, from, precise(moved));
      ASSERT_EQ(entered, expected) << "seed " << kSeed << ", path " << i;
      if (!entered) continue;
      const ObstacleEdge edge = region.edgeOf(entry, entered->edge);
      ASSERT_EQ(edge.half.normal, region.hitOf(entry, {.enter = entered->time, .entered = entered->edge}).normal);
      ++hits;
    }
  }
  EXPECT_GT(hits, 100 * static_cast<int>(Region::kMaxObstacles));
}

// Every shape is in the memory of the one before.
TEST(RegionTest, AForgottenShapeLeavesNothing) {
  const MapGeometry part = crowdedPart(400, 30000);
  sim::SeededRandom random(kSeed);
  Convex shape = square(1000);
  Region region;
  Region::Work work;
  Sweep sweep;
  for (int i = 0; i < 40; ++i) {
    region.forgetShape();
    shape = randomConvex(random, i % 2 == 0 ? 4000 : 12000);
    sweep.start(shape, random.vector(300), random.vector(5000));
    region.cover(part, sweep.bounds(), work);
    for (std::size_t entry = 0; entry < region.segments().size(); ++entry) {
      const auto expected = sweep.against(part.segments[region.segments()[entry]]);
      const auto interval = region.clip(sweep, entry, shape);
      ASSERT_EQ(interval.has_value(), expected.has_value()) << "seed " << kSeed << ", shape " << i;
      if (!interval) continue;
      ASSERT_EQ(region.hitOf(entry, *interval).time, expected->time) << "seed " << kSeed << ", shape " << i;
    }
  }
}

TEST(RegionTest, FindsSegmentsInABox) {
  MapGeometry part;
  part.segments = {{{100, 0}, {200, 0}}, {{0, 100}, {0, 200}}};
  part.grid = Grid(part.segments);
  Region region;
  Region::Work work;
  EXPECT_FALSE(region.mayOverlap(Box{{0, 0}, {100, 100}})) << "it is empty";
  region.cover(part, {{-1000, -1000}, {1000, 1000}}, work);
  EXPECT_TRUE(region.mayOverlap(Box{{0, 0}, {100, 100}})) << "touching counts";
  EXPECT_FALSE(region.mayOverlap(Box{{1, 1}, {99, 99}}));
}

// Also when there are more obstacles than are kept, and after refills.
TEST(RegionTest, ClipsLikeASweepWithoutIt) {
  const MapGeometry part = crowdedPart(4000, 60000);
  const Convex shapes[] = {Convex({{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}}),
                           Convex({{-12000, 0}, {0, -12000}, {12000, 0}, {0, 12000}})};
  sim::SeededRandom random(kSeed);
  Region region;
  Region::Work work;
  Sweep sweep;
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Convex& shape = shapes[i / 7 % 2];
    sweep.start(shape, random.vector(i % 5 == 0 ? 40000 : 3000), random.vector(i % 2 == 0 ? 5000 : 50));
    region.cover(part, sweep.bounds(), work);
    for (std::size_t entry = 0; entry < region.segments().size(); ++entry) {
      const auto expected = sweep.against(part.segments[region.segments()[entry]]);
      const auto interval = region.clip(sweep, entry, shape);
      ASSERT_EQ(interval.has_value(), expected.has_value()) << "seed " << kSeed << ", sweep " << i;
      if (!interval) continue;
      const Hit hit = region.hitOf(entry, *interval);
      ASSERT_EQ(std::tie(hit.time, hit.exit, hit.normal, hit.feature, hit.side),
                std::tie(expected->time, expected->exit, expected->normal, expected->feature, expected->side));
      ++hits;
    }
  }
  EXPECT_GT(hits, 100 * static_cast<int>(Region::kMaxObstacles));
}

}  // namespace
}  // namespace platon::region_test
