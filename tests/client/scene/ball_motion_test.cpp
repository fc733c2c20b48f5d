#include "client/scene/ball_motion.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::ball_motion_test {
namespace {

constexpr double kRadius = 12;
constexpr double kFrame = 1.0 / 60;

class BallMotionTest : public testing::Test {
 protected:
  void moveTo(glm::dvec2 place) { motion_.advance(mesh_, mesh_.pose(0, place, 0), seconds_ += kFrame); }
  std::size_t marks() const {
    std::vector<FaceMark> all;
    motion_.addMarks(Colour(1), Colour(1), all);
    return all.size();
  }

  SolidMesh mesh_{SolidKind::kHexahedron, 480};
  BallMotion motion_{kRadius};
  double seconds_ = 1;
};

TEST_F(BallMotionTest, RollsOneTurnOnAWayOfItsCircumference) {
  moveTo({-50, 0});
  const double way = 2 * 3.14159265358979 * kRadius;
  for (int i = 1; i <= 50; ++i) moveTo({-50 + way * i / 50 / 2, 0});
  const glm::dvec3 turned = motion_.orientation() * glm::dvec3(mesh_.faceToWorld(0)[2]);
  EXPECT_NEAR(glm::dot(turned, mesh_.normal(0)), -1, 1e-6) << "half a turn";
  for (int i = 1; i <= 50; ++i) moveTo({-50 + way / 2 + way * i / 50 / 2, 0});
  EXPECT_NEAR(std::abs(motion_.orientation().w), 1, 1e-6);
}

TEST_F(BallMotionTest, ALandingSquashesTheBallForAMoment) {
  for (int i = 0; i < 20; ++i) moveTo({0, 100 - 8 * i});
  EXPECT_EQ(motion_.squash(), 0);
  EXPECT_EQ(marks() > 0, true) << "the trail";
  const std::size_t before = marks();
  moveTo({0, -52});
  moveTo({0, -52});
  EXPECT_GT(motion_.squash(), 0.05);
  EXPECT_LE(motion_.squash(), BallMotion::kMaxSquash);
  EXPECT_GT(marks(), before) << "dust";
  for (int i = 0; i < 60; ++i) moveTo({0, -52});
  EXPECT_LT(motion_.squash(), 1e-3);
  EXPECT_EQ(marks(), 0U);
}

TEST_F(BallMotionTest, ATakeOffMakesDustButNoSquash) {
  moveTo({0, 0});
  moveTo({0, 0});
  EXPECT_EQ(marks(), 0U);
  moveTo({0, 6});
  EXPECT_GT(marks(), 4U);
  EXPECT_EQ(motion_.squash(), 0);
}

TEST_F(BallMotionTest, AJumpOrAnEarlierTimeBeginsAnew) {
  for (int i = 0; i < 20; ++i) moveTo({5.0 * i, 0});
  EXPECT_GT(marks(), 0U);
  moveTo({-150, 0});
  EXPECT_EQ(marks(), 0U);
  EXPECT_EQ(motion_.orientation(), glm::dquat(1, 0, 0, 0));
  for (int i = 0; i < 20; ++i) moveTo({-150 + 5.0 * i, 0});
  seconds_ = 0;
  moveTo({-50, 0});
  EXPECT_EQ(marks(), 0U);
}

TEST_F(BallMotionTest, TheSameTimeChangesNothing) {
  for (int i = 0; i < 20; ++i) moveTo({5.0 * i, 0});
  const glm::dquat before = motion_.orientation();
  motion_.advance(mesh_, mesh_.pose(0, {100, 0}, 0), seconds_);
  EXPECT_EQ(motion_.orientation(), before);
}

TEST(SurfaceLift, TurnsContinuouslyFromNormalToNormal) {
  for (const SolidKind kind : {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kIcosahedron}) {
    const SolidMesh mesh(kind, 300);
    const int next = mesh.solid().neighbour(0, 0).face;
    const glm::dvec2 down = mesh.edgeNormals()[0];
    const glm::dvec3 edge = mesh.toWorld(0, down * mesh.apothem());
    const glm::dvec3 bisector = glm::normalize(mesh.normal(0) + mesh.normal(next));
    EXPECT_LT(glm::distance(liftAt(mesh, edge, kRadius), bisector), 1e-9);
    EXPECT_LT(glm::distance(liftAt(mesh, mesh.toWorld(0, down * (mesh.apothem() - kRadius)), kRadius), mesh.normal(0)),
              1e-9);
    glm::dvec3 last = mesh.normal(0);
    for (double out = kRadius; out > 0; out -= 0.1) {
      const glm::dvec3 lift = liftAt(mesh, mesh.toWorld(0, down * (mesh.apothem() - out)), kRadius);
      EXPECT_LT(glm::distance(lift, last), 0.03);
      EXPECT_LE(glm::dot(lift, mesh.normal(0)), glm::dot(last, mesh.normal(0)) + 1e-12);
      last = lift;
    }
  }
}

}  // namespace

}  // namespace platon::ball_motion_test
