#include "tests/exactness/reference/solid_path.h"

#include <gtest/gtest.h>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/terrain.h"

namespace platon::reference::solid_path_test {
namespace {

class SolidPathTest : public testing::Test {
 protected:
  SolidPathTest() { setRealPrecision(); }
};

const oracle::Polygon kBox = {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}};

/// Two squares of half-width 1000, side by side; the second one is turned by 90 degrees.
SolidScene twoSquares() {
  SolidScene scene;
  scene.faces.resize(2);
  scene.faces[0].warps.push_back({{{1000, -1000}, {1000, 1000}}, 1, 9000, {1000, 0}, {0, -1000}});
  scene.faces[1].warps.push_back({{{-1000, -1000}, {1000, -1000}}, 0, -9000, {0, -1000}, {1000, 0}});
  for (std::int64_t turn = 0; turn < 36000; turn += 9000) scene.shapes[turn] = kBox;
  return scene;
}

double differs(const Real& a, const Real& b) { return Real(abs(a - b)).get_d(); }

TEST_F(SolidPathTest, DirectionsAreExact) {
  const RealVec direction = directionOf(6000);
  EXPECT_LT(differs(direction.x, 0.5), 1e-140);
  EXPECT_LT(differs(direction.y * direction.y, 0.75), 1e-140);
  EXPECT_EQ(directionOf(-30000).x, direction.x);
}

TEST_F(SolidPathTest, OnOneFaceItIsTheIdealPath) {
  constexpr std::int64_t kTicks = 300;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const ExactScene terrain = randomTerrain(seed, kTicks).scene;
    const IdealPath ideal(terrain, kTicks);
    SolidScene scene;
    scene.faces.push_back({terrain.lines, {}});
    scene.shapes[0] = terrain.shape;
    SolidPath path(scene, 0, terrain.start);
    for (std::int64_t tick = 1; tick <= kTicks; ++tick) {
      path.tick(terrain.velocity, 0);
      const RationalVec at = ideal.positionAt(tick);
      ASSERT_LT(differs(path.place().x, Real(at.x)), 1e-60) << "seed " << seed << ", tick " << tick;
      ASSERT_LT(differs(path.place().y, Real(at.y)), 1e-60) << "seed " << seed << ", tick " << tick;
    }
  }
}

TEST_F(SolidPathTest, AChangeOfTheFrameKeepsThePathAndTurnsIt) {
  const SolidScene scene = twoSquares();
  SolidPath path(scene, 0, {800, 50});
  path.tick({300, 0}, 0);
  path.changeFrame(1);
  EXPECT_LT(differs(path.place().x, -50), 1e-140);
  EXPECT_LT(differs(path.place().y, -900), 1e-140);
  EXPECT_EQ(path.turned(), 9000);
  path.tick({300, 0}, path.turned());
  EXPECT_LT(differs(path.place().y, -600), 1e-140);
  EXPECT_FALSE(path.touched());
}

TEST_F(SolidPathTest, TheBodyStopsAtAWallOfTheNextFace) {
  SolidScene scene = twoSquares();
  scene.faces[1].lines.push_back({{-500, -950}, {500, -950}});
  SolidPath path(scene, 0, {800, 50});
  path.tick({300, 0}, 0);
  EXPECT_LT(differs(path.place().x, 950), 1e-50);
  EXPECT_TRUE(path.touched());
  EXPECT_FALSE(path.wasStoppedAtJoint());
}

TEST_F(SolidPathTest, AnEndThatStopsTheBodyIsAtAJointIfAnotherSegmentReachesIt) {
  for (const std::int64_t gap : {7, 9}) {
    SolidScene scene;
    scene.faces.push_back({{{{-1000, 0}, {1000, 0}}, {{500, gap}, {500, gap}}}, {}});
    scene.shapes[0] = kBox;
    SolidPath path(scene, 0, {0, 100});
    path.tick({600, -10}, 0);
    EXPECT_LT(differs(path.place().x, 400), 1e-50);
    EXPECT_EQ(path.wasStoppedAtJoint(), gap == 7);
  }
}

TEST_F(SolidPathTest, AWedgeWithoutAFreeLatticePointIsNarrow) {
  SolidScene scene;
  scene.faces.push_back({{{{0, 0}, {1000, 50001}}, {{1, 0}, {-1000, 50001}}}, {}});
  scene.shapes[0] = {{0, 0}, {10, 2000}, {-10, 2000}};
  SolidPath path(scene, 0, {0, 30000});
  path.tick({0, -400}, 0);
  EXPECT_FALSE(path.isNarrow(2));
  for (int i = 0; i < 99; ++i) path.tick({0, -400}, 0);
  EXPECT_TRUE(path.isNarrow(2));
}

}  // namespace
}  // namespace platon::reference::solid_path_test
