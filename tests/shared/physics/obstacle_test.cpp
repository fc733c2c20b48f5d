#include "platon/physics/obstacle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/sweep.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::obstacle_test {
namespace {

constexpr std::uint64_t kSeed = 404;

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  if (!a || !b) return !a && !b;
  return a->time == b->time && a->exit == b->exit && a->normal == b->normal && a->feature == b->feature &&
         a->side == b->side;
}

// The caches of an obstacle must not influence any result.
void expectCachedQueriesEqualFreshOnes(int edges, std::int32_t scale) {
  sim::SeededRandom random(kSeed);
  const Convex shape = regular(edges, 1000 * scale);
  Sweep sweep;
  int met = 0;
  for (int round = 0; round < 200; ++round) {
    const Point a = random.vector(1500 * scale);
    const Segment line{a, round % 10 == 0 ? a : a + random.vector(3000 * scale)};
    Obstacle obstacle;
    obstacle.build(shape, line);
    Point at = random.vector(4000 * scale);
    for (int step = 0; step < 200; ++step) {
      const Point way = step % 5 == 0 ? Point() : random.vector((step % 7 == 0 ? 5000 : 300) * scale);
      sweep.start(shape, at, way, step % 3 == 0 ? 4 : 0);
      const auto expected = sweep.against(line);
      if (!sweep.misses(boundsOf(line))) {
        ASSERT_TRUE(same(sweep.against(obstacle), expected))
            << edges << " edges, seed " << kSeed << ", round " << round << ", step " << step;
      }
      met += expected.has_value();
      at = squaredLength(at + way) < std::int64_t{36'000'000} * scale * scale ? at + way : Point();
    }
  }
  EXPECT_GT(met, 4000);
}

TEST(ObstacleTest, CachedQueriesEqualFreshQueries) { expectCachedQueriesEqualFreshOnes(8, 1); }

// More half planes than there are groups of them.
TEST(ObstacleTest, CachedQueriesOfAShapeWithManyEdgesEqualFreshQueries) { expectCachedQueriesEqualFreshOnes(200, 100); }

TEST(ObstacleTest, OtherHalfPlanesContainTheBox) {
  sim::SeededRandom random(kSeed);
  const Convex shape = regular(8, 1000);
  Obstacle obstacle;
  obstacle.build(shape, {{-700, 100}, {900, -300}});
  ASSERT_EQ(obstacle.halfPlaneCount(), shape.vertices().size() + 2);
  for (int i = 0; i < 2000; ++i) {
    const Point low = random.vector(2500);
    const auto width = static_cast<std::int32_t>(random.below(600));
    const auto height = static_cast<std::int32_t>(random.below(600));
    const Box way{low, low + Point(width, height)};
    std::vector<std::size_t> boundaries;
    obstacle.visitRelevant(way, [&](std::size_t index) {
      boundaries.push_back(index);
      return true;
    });
    ASSERT_TRUE(std::is_sorted(boundaries.begin(), boundaries.end()));
    for (std::size_t j = 0; j < obstacle.halfPlaneCount(); ++j) {
      if (std::find(boundaries.begin(), boundaries.end(), j) != boundaries.end()) continue;
      const Obstacle::HalfPlane half = obstacle.halfPlane(j);
      for (const Point corner : {way.low, way.high, Point(way.low.x, way.high.y), Point(way.high.x, way.low.y)}) {
        ASSERT_LT(dot(half.normal, corner) + half.offset, 0)
            << "seed " << kSeed << ", box " << i << ", half plane " << j;
      }
    }
  }
}

}  // namespace
}  // namespace platon::obstacle_test
