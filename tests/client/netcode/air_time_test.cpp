#include "client/netcode/air_time.h"

#include <gtest/gtest.h>

#include <vector>

#include "platon/game/game.h"
#include "tests/client/netcode/player_states.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

TEST(AirTime, CountsTheTicksSinceThePlayerStood) {
  AirTime air;
  air.observe(1, standing());
  EXPECT_EQ(air.ticks(), 0u);
  for (std::uint32_t tick = 2; tick <= 100; ++tick) {
    air.observe(tick, falling());
    EXPECT_EQ(air.ticks(), tick - 1);
  }
  air.observe(101, standing());
  EXPECT_EQ(air.ticks(), 0u);
}

TEST(AirTime, TheHintIsNeededAfter240TicksUntilThePlayerLandsOrRestarts) {
  PlayerState restarting = falling();
  restarting.held = Input::kRestart;
  for (const PlayerState& end : {standing(), restarting, PlayerState()}) {
    AirTime air;
    air.observe(1, standing());
    for (std::uint32_t tick = 2; tick <= 240; ++tick) air.observe(tick, falling());
    EXPECT_FALSE(air.needsHint());
    air.observe(241, falling());
    EXPECT_TRUE(air.needsHint());
    air.observe(5000, falling());
    EXPECT_TRUE(air.needsHint());
    air.observe(5001, end);
    EXPECT_FALSE(air.needsHint());
    air.observe(5002, falling());
    EXPECT_EQ(air.ticks(), 1u);
  }
}

TEST(AirTime, ReplayedTicksAreIgnored) {
  AirTime air;
  air.observe(10, standing());
  for (std::uint32_t tick = 11; tick <= 20; ++tick) air.observe(tick, falling());
  for (std::uint32_t tick = 15; tick <= 20; ++tick) air.observe(tick, standing());
  EXPECT_EQ(air.ticks(), 10u);
}

// A player who joins is observed late: what was before is not known.
TEST(AirTime, CountsFromTheFirstObservation) {
  AirTime air;
  air.observe(9000, falling());
  EXPECT_EQ(air.ticks(), 0u);
  air.observe(9001, falling());
  EXPECT_EQ(air.ticks(), 1u);
}

TEST(AirTime, APlayerOfAGameNeedsNoHintWhileItRunsAndJumps) {
  Game game(endlessLevel());
  AirTime air;
  for (int tick = 0; tick < 1200; ++tick) {
    const std::uint8_t jump = tick % 3 == 0 ? Input::kJump : 0;
    game.advance(std::vector{Input{static_cast<std::uint8_t>(Input::kPresent | Input::kRight | jump)}});
    air.observe(game.tick(), game.player(0));
    ASSERT_FALSE(air.needsHint()) << tick;
  }
}

}  // namespace
}  // namespace platon
