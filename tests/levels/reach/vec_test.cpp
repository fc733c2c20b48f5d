#include "levels/reach/vec.h"

#include <gtest/gtest.h>

#include <random>

namespace platon::vec_test {
namespace {

constexpr unsigned kSeed = 11;

TEST(VecTest, DistanceOfAPointFromALine) {
  const Line line{{0, 0}, {10, 0}};
  EXPECT_DOUBLE_EQ(distance(Vec{5, 3}, line), 3);
  EXPECT_DOUBLE_EQ(distance(Vec{13, 4}, line), 5);
  EXPECT_DOUBLE_EQ(distance(Vec{-3, -4}, line), 5);
  EXPECT_DOUBLE_EQ(distance(Vec{3, 4}, Line{{0, 0}, {0, 0}}), 5) << "a line without length is a point";
}

TEST(VecTest, ARectangleThatMeetsALineHasNoDistance) {
  const Rect rect{{0, 0}, {4, 4}};
  EXPECT_EQ(distance(rect, Line{{-5, 2}, {9, 2}}), 0) << "across";
  EXPECT_EQ(distance(rect, Line{{1, 1}, {2, 2}}), 0) << "inside";
  EXPECT_EQ(distance(rect, Line{{4, 4}, {9, 9}}), 0) << "touching";
  EXPECT_GT(distance(rect, Line{{4.1, 4.1}, {9, 9}}), 0);
}

// The distance is the smallest of the distances of many points of the rectangle.
TEST(VecTest, DistanceOfARectangleIsThatOfItsNearestPoint) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-20, 20);
  const Rect rect{{-3, -2}, {3, 4}};
  for (int round = 0; round < 200; ++round) {
    const Line line{{coordinate(random), coordinate(random)}, {coordinate(random), coordinate(random)}};
    double nearest = 1e9;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j <= 60; ++j) nearest = std::min(nearest, distance(rect.low + Vec{i * 0.1, j * 0.1}, line));
    }
    EXPECT_NEAR(distance(rect, line), nearest, 0.08) << "seed " << kSeed << ", round " << round;
    EXPECT_LE(distance(rect, line), nearest + 1e-9);
  }
}

TEST(VecTest, UprightTurnsUpToY) {
  const Vec upright = uprightOf({-3 * kSubunitsPerUnit, 0}, Angle::degrees(90));
  EXPECT_NEAR(upright.x, 0, 1e-9);
  EXPECT_NEAR(upright.y, 3, 1e-9) << "at 90 degrees, -x is up";
}

}  // namespace
}  // namespace platon::vec_test
