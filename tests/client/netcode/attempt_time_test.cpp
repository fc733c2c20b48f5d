#include "client/netcode/attempt_time.h"

#include <gtest/gtest.h>

#include <vector>

#include "platon/game/game.h"
#include "tests/support/test_level.h"

namespace platon::attempt_time_test {
namespace {

PlayerState startedAt(std::uint32_t tick) {
  PlayerState player;
  player.present = 1;
  player.startedAt = tick;
  return player;
}

PlayerState arrivedAt(std::uint32_t start, std::uint32_t best) {
  PlayerState player = startedAt(start);
  player.arrived = 1;
  player.finishTicks = best;
  return player;
}

TEST(AttemptTime, RunsFromTheFirstInput) {
  AttemptTime time;
  time.observe(40, startedAt(0));
  EXPECT_EQ(time.ticks(), 0u);
  time.observe(41, startedAt(41));
  EXPECT_EQ(time.ticks(), 1u);
  time.observe(141, startedAt(41));
  EXPECT_EQ(time.ticks(), 101u);
  EXPECT_FALSE(time.arrived());
}

TEST(AttemptTime, StandsStillAfterTheArrivalUntilARestart) {
  AttemptTime time;
  time.observe(50, startedAt(41));
  time.observe(60, arrivedAt(41, 20));
  time.observe(90, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
  EXPECT_TRUE(time.arrived());
  PlayerState again = startedAt(0);
  again.finishTicks = 20;
  time.observe(91, again);
  EXPECT_EQ(time.ticks(), 0u);
  EXPECT_FALSE(time.arrived());
}

TEST(AttemptTime, ASlowerAttemptKeepsItsOwnTime) {
  AttemptTime time;
  time.observe(60, arrivedAt(41, 20));
  PlayerState again = startedAt(100);
  again.finishTicks = 20;
  time.observe(120, again);
  time.observe(130, arrivedAt(100, 20));
  time.observe(160, arrivedAt(100, 20));
  EXPECT_EQ(time.ticks(), 31u);
}

// The state knows the exact time where the prediction learns of the arrival late.
TEST(AttemptTime, ANewBestTimeIsThatOfTheGame) {
  AttemptTime time;
  time.observe(60, startedAt(41));
  time.observe(64, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, APlayerWhoRejoinsAtTheGoalHasItsBestTime) {
  AttemptTime time;
  time.observe(500, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, ReplayedTicksAreIgnored) {
  AttemptTime time;
  time.observe(60, startedAt(41));
  time.observe(50, startedAt(0));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, IsTheTimeOfTheGame) {
  Game game(flatLevel());
  AttemptTime time;
  const auto advance = [&](std::uint8_t buttons) {
    game.advance(std::vector{Input{static_cast<std::uint8_t>(Input::kPresent | buttons)}});
    time.observe(game.tick(), game.player(0));
  };
  for (int tick = 0; tick < 30; ++tick) advance(0);
  EXPECT_EQ(time.ticks(), 0u);
  while (!game.player(0).finished() && game.tick() < 1000) advance(Input::kRight);
  ASSERT_TRUE(game.player(0).finished());
  EXPECT_EQ(time.ticks(), game.player(0).finishTicks);
  for (int tick = 0; tick < 30; ++tick) advance(0);
  EXPECT_EQ(time.ticks(), game.player(0).finishTicks);
}

}  // namespace
}  // namespace platon::attempt_time_test
