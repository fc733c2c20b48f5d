#include "client/time/clock.h"

#include <chrono>

#include <gtest/gtest.h>

namespace platon::clock_test {
namespace {

using std::chrono::seconds;

class PausableClockTest : public testing::Test {
 protected:
  Time source_ = seconds(100);
  PausableClock clock_{[this] { return source_; }};
};

TEST_F(PausableClockTest, FollowsItsSource) {
  EXPECT_EQ(clock_.now(), seconds(100));
  source_ += seconds(5);
  EXPECT_EQ(clock_.now(), seconds(105));
  EXPECT_FALSE(clock_.paused());
}

TEST_F(PausableClockTest, StandsStillInAPauseAndGoesOnFromThere) {
  clock_.setPaused(true);
  source_ += seconds(60);
  clock_.setPaused(true);
  EXPECT_TRUE(clock_.paused());
  EXPECT_EQ(clock_.now(), seconds(100));
  source_ += seconds(60);
  clock_.setPaused(false);
  EXPECT_EQ(clock_.now(), seconds(100));
  clock_.setPaused(false);
  source_ += seconds(3);
  EXPECT_EQ(clock_.now(), seconds(103));
}

TEST_F(PausableClockTest, SeveralPausesAddUp) {
  for (int i = 0; i < 10; ++i) {
    clock_.setPaused(true);
    source_ += seconds(7);
    clock_.setPaused(false);
    source_ += seconds(1);
  }
  EXPECT_EQ(clock_.now(), seconds(110));
}

TEST_F(PausableClockTest, RunsAtItsSpeedFromTheChangeOn) {
  source_ += seconds(4);
  clock_.setSpeed(0.5);
  EXPECT_EQ(clock_.now(), seconds(104));
  source_ += seconds(6);
  EXPECT_EQ(clock_.now(), seconds(107));
  clock_.setPaused(true);
  source_ += seconds(50);
  clock_.setSpeed(0.75);
  EXPECT_EQ(clock_.now(), seconds(107));
  clock_.setPaused(false);
  source_ += seconds(4);
  EXPECT_EQ(clock_.now(), seconds(110));
  clock_.setSpeed(1);
  source_ += seconds(1);
  EXPECT_EQ(clock_.now(), seconds(111));
}

TEST_F(PausableClockTest, NeverGoesBackWhateverIsChanged) {
  Time last = clock_.now();
  for (int i = 0; i < 1000; ++i) {
    source_ += std::chrono::microseconds(i * 37 % 1000);
    if (i % 3 == 0) clock_.setSpeed(0.5 + 0.05 * (i % 11));
    if (i % 7 == 0) clock_.setPaused(i % 2 == 0);
    EXPECT_GE(clock_.now(), last);
    last = clock_.now();
  }
}

}  // namespace
}  // namespace platon::clock_test
