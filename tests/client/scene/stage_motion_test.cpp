#include "client/scene/stage_motion.h"

#include <gtest/gtest.h>

namespace platon::stage_motion_test {
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

TEST(GoalMotion, OpensAndBurstsWhenThePlayerArrives) {
  GoalMotion goal;
  goal.advance(false, 5);
  EXPECT_EQ(goal.opened(), 0);
  EXPECT_EQ(goal.burst(), 1);
  goal.advance(true, 6);
  EXPECT_EQ(goal.opened(), 0);
  EXPECT_EQ(goal.burst(), 0);
  goal.advance(true, 6 + GoalMotion::kOpening / 2);
  EXPECT_NEAR(goal.opened(), 0.5, 1e-9);
  goal.advance(true, 6 + GoalMotion::kBurst);
  EXPECT_EQ(goal.opened(), 1);
  EXPECT_NEAR(goal.burst(), 1, 1e-9);
}

TEST(GoalMotion, ClosesWhenANewAttemptBegins) {
  GoalMotion goal;
  goal.advance(false, 1);
  goal.advance(true, 2);
  goal.advance(true, 9);
  goal.advance(false, 10);
  EXPECT_EQ(goal.opened(), 0);
  EXPECT_EQ(goal.burst(), 1);
}

TEST(GoalMotion, SettledItIsOpenOrClosedAtOnce) {
  GoalMotion goal;
  goal.advance(false, 1);
  goal.settle();
  EXPECT_EQ(goal.opened(), 0);
  goal.advance(true, 2);
  goal.settle();
  EXPECT_EQ(goal.opened(), 1);
  EXPECT_EQ(goal.burst(), 1);
}

TEST(GoalMotion, AnOldArrivalIsOpenWithoutABurst) {
  GoalMotion goal;
  goal.advance(true, 100);
  EXPECT_EQ(goal.opened(), 1);
  EXPECT_EQ(goal.burst(), 1);
  goal.advance(true, 3);
  EXPECT_EQ(goal.opened(), 1) << "the time began anew";
  EXPECT_EQ(goal.burst(), 1);
}

}  // namespace

}  // namespace platon::stage_motion_test
