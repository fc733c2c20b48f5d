#include "client/play/match/live_match.h"

#include <gtest/gtest.h>

namespace platon::attempt_speed_test {
namespace {

PlayerState startedAt(std::uint32_t tick) {
  PlayerState player;
  player.startedAt = tick;
  return player;
}

TEST(AttemptSpeed, IsTheLeastOfTheAttempt) {
  AttemptSpeed speed;
  EXPECT_EQ(speed.least(), 1);
  speed.observe(1, startedAt(5), 0.8);
  speed.observe(1, startedAt(5), 0.5);
  speed.observe(1, startedAt(5), 1);
  EXPECT_EQ(speed.least(), 0.5);
}

TEST(AttemptSpeed, ANewAttemptAtFullSpeedIsNotSlowed) {
  AttemptSpeed speed;
  speed.observe(1, startedAt(5), 0.5);
  speed.observe(1, startedAt(0), 1);
  speed.observe(1, startedAt(9), 1);
  EXPECT_EQ(speed.least(), 1);
  speed.observe(1, startedAt(9), 0.5);
  speed.observe(1, startedAt(20), 1);  // begun again at once
  EXPECT_EQ(speed.least(), 1);
  speed.observe(1, startedAt(20), 0.5);
  speed.observe(2, startedAt(20), 1);  // in the next round
  EXPECT_EQ(speed.least(), 1);
}

TEST(AttemptSpeed, WhatIsSlowedAfterTheGoalIsNotTheAttempt) {
  AttemptSpeed speed;
  PlayerState player = startedAt(5);
  speed.observe(1, player, 1);
  player.arrived = 1;
  speed.observe(1, player, 0.5);
  EXPECT_EQ(speed.least(), 1);
}

}  // namespace
}  // namespace platon::attempt_speed_test
