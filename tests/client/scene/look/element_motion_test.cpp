#include "client/scene/look/element_motion.h"

#include <gtest/gtest.h>

namespace platon::element_motion_test {
namespace {

using Shares = std::vector<double>;

TEST(ElementMotion, BeginsWithNothingInMotion) {
  ElementMotion motion;
  motion.advance({1, 0}, 5);
  EXPECT_EQ(motion.shares(), (Shares{1, 0}));
}

TEST(ElementMotion, AChangeTakesItsTimeAndEndsExactly) {
  ElementMotion motion;
  motion.advance({1, 0, 1}, 5);
  motion.advance({0, 1, 1}, 5 + ElementMotion::kSeconds / 2);
  EXPECT_NEAR(motion.shares()[0], 0.5, 1e-9);
  EXPECT_NEAR(motion.shares()[1], 0.5, 1e-9);
  EXPECT_EQ(motion.shares()[2], 1);
  motion.advance({0, 1, 1}, 5 + 2 * ElementMotion::kSeconds);
  EXPECT_EQ(motion.shares(), (Shares{0, 1, 1}));
}

TEST(ElementMotion, ADoorThatClosesAgainTurnsBackWhereItIs) {
  ElementMotion motion;
  motion.advance({1}, 5);
  motion.advance({0}, 5 + ElementMotion::kSeconds / 2);
  const double half = motion.shares()[0];
  motion.advance({1}, 5 + 0.6 * ElementMotion::kSeconds);
  EXPECT_GT(motion.shares()[0], half);
  EXPECT_LT(motion.shares()[0], 1);
}

TEST(ElementMotion, SettledNothingMoves) {
  ElementMotion motion;
  motion.advance({1}, 5);
  motion.advance({0}, 5.01);
  motion.settle();
  EXPECT_EQ(motion.shares(), Shares{0});
}

TEST(ElementMotion, AnEarlierTimeOrAnotherLevelBeginsAnew) {
  ElementMotion motion;
  motion.advance({1}, 5);
  motion.advance({0}, 4);
  EXPECT_EQ(motion.shares(), Shares{0});
  motion.advance({1}, 4);
  EXPECT_EQ(motion.shares(), Shares{1}) << "without time";
  motion.advance({1, 1}, 4.01);
  EXPECT_EQ(motion.shares(), (Shares{1, 1}));
}

}  // namespace
}  // namespace platon::element_motion_test
