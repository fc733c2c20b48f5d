#include "tests/exactness/reference/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

namespace platon::reference::terrain_test {
namespace {

using oracle::Segment;
using oracle::Vec;

constexpr std::int64_t kTicks = 1200;
constexpr std::uint64_t kSeeds = 200;

bool misses(Vec a, Vec b) { return a != b && std::abs(a.x - b.x) <= 2 && std::abs(a.y - b.y) <= 2; }

bool hasLooseJoint(const ExactScene& scene) {
  for (const Segment& a : scene.lines) {
    for (const Segment& b : scene.lines) {
      if (misses(a.a, b.a) || misses(a.a, b.b) || misses(a.b, b.b)) return true;
    }
  }
  return false;
}

TEST(TerrainTest, HasBodiesOfAllKindsBetween12And24Units) {
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Terrain terrain = randomTerrain(seed, kTicks);
    kinds.insert(terrain.shape);
    EXPECT_TRUE(oracle::isStrictlyConvex(terrain.scene.shape));
    const oracle::Box box = oracle::boxOf(terrain.scene.shape);
    const std::int64_t size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    EXPECT_GE(size, 8 * kTerrainSubunits);
    EXPECT_LE(size, 27 * kTerrainSubunits);
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"box", "hexagon", "octagon", "triangle"}));
}

TEST(TerrainTest, HasLooseJointsAndPoints) {
  std::uint64_t loose = 0;
  std::uint64_t points = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const ExactScene scene = randomTerrain(seed, kTicks).scene;
    loose += hasLooseJoint(scene);
    points += std::any_of(scene.lines.begin(), scene.lines.end(), [](const Segment& s) { return s.a == s.b; });
  }
  EXPECT_GT(loose, kSeeds / 2);
  EXPECT_GT(points, kSeeds / 4);
}

}  // namespace
}  // namespace platon::reference::terrain_test
