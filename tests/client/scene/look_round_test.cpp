#include "client/scene/look_round.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::look_round_test {
namespace {

const ViewPoint kView{{1, 0, 0, 0}, {30, -20, 1000}};

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, 480);
  return mesh;
}

LookInput towards(double right, double up) { return {true, {right, up}}; }

TEST(LookRound, TurnsWhileItIsHeld) {
  LookRound look;
  look.update(towards(1, 0), 0.25);
  EXPECT_NEAR(look.angles().x, LookRound::kSpeed / 4, 1e-12);
  look.update(towards(0, 0), 1);
  EXPECT_NEAR(look.angles().x, LookRound::kSpeed / 4, 1e-12) << "held without a direction, it stays";
  look.update(towards(0, -1), 0.1);
  EXPECT_NEAR(look.angles().y, -LookRound::kSpeed / 10, 1e-12);
}

TEST(LookRound, RightAndUpAreThoseOfTheScreen) {
  LookRound look;
  look.update(towards(1, 0), 0.3);
  EXPECT_GT(look.turned(kView, cube()).back().x, 0.3);
  look.reset();
  look.update(towards(0, 1), 0.3);
  EXPECT_GT(look.turned(kView, cube()).back().y, 0.3);
}

TEST(LookRound, GoesBackToTheSameView) {
  LookRound look;
  look.update(towards(1, 1), 0.5);
  double last = glm::length(look.angles());
  for (int step = 0; step < 300; ++step) {
    look.update({}, 1.0 / 60);
    const double now = glm::length(look.angles());
    EXPECT_LE(now, last);
    EXPECT_LE(last - now, LookRound::kMaxReturn / 60 + 1e-9);
    last = now;
  }
  EXPECT_LT(glm::distance(look.turned(kView, cube()).eye, kView.eye), 1e-6);
}

TEST(LookRound, TwoReturnsEqualOneOfTheSum) {
  LookRound once;
  once.update(towards(1, 0.5), 1);
  LookRound twice = once;
  once.update({}, 0.3);
  twice.update({}, 0.1);
  twice.update({}, 0.2);
  EXPECT_LT(glm::distance(once.angles(), twice.angles()), 1e-9);
}

TEST(LookRound, SeesEverySideAndReturnsTheShortWay) {
  LookRound look;
  look.update(towards(1, 0), 1.2 * std::numbers::pi / LookRound::kSpeed);
  EXPECT_NEAR(look.angles().x, -0.8 * std::numbers::pi, 1e-9);
  look.update(towards(0, 1), 100);
  EXPECT_EQ(look.angles().y, LookRound::kMaxUp);
}

TEST(LookRound, WithoutAnglesItChangesNothing) {
  const ViewPoint view = LookRound().turned(kView, cube());
  EXPECT_EQ(view.eye, kView.eye);
  EXPECT_EQ(view.orientation, kView.orientation);
}

TEST(LookRound, ATurnIsMadeAtOnceWithinTheLimits) {
  LookRound look;
  look.update({true, {}, {0.3, -0.2}}, 0);
  EXPECT_EQ(look.angles(), glm::dvec2(0.3, -0.2));
  look.update({true, {}, {0, 9}}, 0);
  EXPECT_EQ(look.angles().y, LookRound::kMaxUp);
  look.update({}, 5);
  EXPECT_LT(glm::length(look.angles()), 1e-3) << "it goes back";
}

}  // namespace
}  // namespace platon::look_round_test
