#include "client/scene/look/goal_motion.h"

#include <gtest/gtest.h>

namespace platon::goal_motion_test {
namespace {

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
}  // namespace platon::goal_motion_test
