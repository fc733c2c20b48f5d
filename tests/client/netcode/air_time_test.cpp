#include "client/netcode/air_time.h"

#include <gtest/gtest.h>

#include <vector>

#include "platon/game/game.h"
#include "tests/client/netcode/player_states.h"
#include "tests/support/test_level.h"

namespace platon::air_time_test {
namespace {

TEST(AirTime, CountsTheTicksSinceThePlayerStood) {
  AirTime air;
  air.observe(1, standing(), 0);
  EXPECT_EQ(air.ticks(), 0u);
  for (std::uint32_t tick = 2; tick <= 100; ++tick) {
    air.observe(tick, falling(), 0);
    EXPECT_EQ(air.ticks(), tick - 1);
  }
  air.observe(101, standing(), 0);
  EXPECT_EQ(air.ticks(), 0u);
}

TEST(AirTime, TheHintIsNeededAfter240TicksUntilThePlayerLandsOrRestarts) {
  PlayerState restarting = falling();
  restarting.held = Input::kRestart;
  for (const PlayerState& end : {standing(), restarting, PlayerState()}) {
    AirTime air;
    air.observe(1, standing(), 0);
    for (std::uint32_t tick = 2; tick <= 240; ++tick) air.observe(tick, falling(), 0);
    EXPECT_FALSE(air.needsHint());
    air.observe(241, falling(), 0);
    EXPECT_TRUE(air.needsHint());
    air.observe(5000, falling(), 0);
    EXPECT_TRUE(air.needsHint());
    air.observe(5001, end, 0);
    EXPECT_FALSE(air.needsHint());
    air.observe(5002, falling(), 0);
    EXPECT_EQ(air.ticks(), 1u);
  }
}

TEST(AirTime, TheHintIsNeededOnTheThirdFaceUntilThePlayerLandsOrRestarts) {
  PlayerState restarting = falling();
  restarting.held = Input::kRestart;
  for (const PlayerState& end : {standing(), restarting, PlayerState()}) {
    AirTime air;
    air.observe(1, standing(), 19);
    air.observe(2, falling(), 19);
    air.observe(3, falling(), 7);
    EXPECT_FALSE(air.needsHint());
    air.observe(4, falling(), 8);
    EXPECT_TRUE(air.needsHint());
    air.observe(5, end, 8);
    EXPECT_FALSE(air.needsHint());
    air.observe(6, falling(), 7);
    EXPECT_FALSE(air.needsHint());
  }
}

TEST(AirTime, AJumpOverAnEdgeAndBackNeedsNoHint) {
  AirTime air;
  air.observe(1, standing(), 0);
  for (std::uint32_t tick = 2; tick < AirTime::kHintTicks; ++tick) {
    air.observe(tick, falling(), tick / 20 % 2);
    ASSERT_FALSE(air.needsHint()) << tick;
  }
}

TEST(AirTime, ReplayedTicksAreIgnored) {
  AirTime air;
  air.observe(10, standing(), 0);
  for (std::uint32_t tick = 11; tick <= 20; ++tick) air.observe(tick, falling(), 0);
  for (std::uint32_t tick = 15; tick <= 20; ++tick) air.observe(tick, standing(), 0);
  EXPECT_EQ(air.ticks(), 10u);
}

// A player who joins is observed late: what was before is not known.
TEST(AirTime, CountsFromTheFirstObservation) {
  AirTime air;
  air.observe(9000, falling(), 0);
  EXPECT_EQ(air.ticks(), 0u);
  air.observe(9001, falling(), 0);
  EXPECT_EQ(air.ticks(), 1u);
}

TEST(AirTime, APlayerOfAGameNeedsNoHintWhileItRunsAndJumps) {
  Game game(endlessLevel());
  AirTime air;
  for (int tick = 0; tick < 1200; ++tick) {
    const std::uint8_t jump = tick % 3 == 0 ? Input::kJump : 0;
    game.advance(std::vector{Input{static_cast<std::uint8_t>(Input::kPresent | Input::kRight | jump)}});
    air.observe(game.tick(), game.player(0), game.world().entities()[0].part);
    ASSERT_FALSE(air.needsHint()) << tick;
  }
}

}  // namespace
}  // namespace platon::air_time_test
