#include "client/netcode/player_flashes.h"

#include <gtest/gtest.h>

#include "tests/client/netcode/player_states.h"

namespace platon::player_flashes_test {
namespace {

// The player stands, falls from tick 10 on, and lands at tick `landing`.
void fall(PlayerFlashes& flashes, std::uint32_t slot, std::uint32_t landing) {
  for (std::uint32_t tick = 1; tick < 10; ++tick) flashes.observe(slot, tick, standing());
  for (std::uint32_t tick = 10; tick < landing; ++tick) flashes.observe(slot, tick, falling());
  flashes.observe(slot, landing, standing());
}

TEST(PlayerFlashes, ALandingFlashesAtItsTickAndFades) {
  PlayerFlashes flashes;
  fall(flashes, 3, 40);
  EXPECT_EQ(flashes.brightness(3, 39.9), 0);
  EXPECT_EQ(flashes.brightness(3, 40), 1);
  EXPECT_DOUBLE_EQ(flashes.brightness(3, 40 + PlayerFlashes::kTicks / 2.0), 0.5);
  EXPECT_EQ(flashes.brightness(3, 40 + PlayerFlashes::kTicks), 0);
  EXPECT_EQ(flashes.brightness(2, 40), 0);
  EXPECT_EQ(flashes.brightness(9, 40), 0);
}

TEST(PlayerFlashes, ReplayedTicksAreIgnored) {
  PlayerFlashes flashes;
  fall(flashes, 0, 40);
  for (std::uint32_t tick = 30; tick < 38; ++tick) flashes.observe(0, tick, falling());
  flashes.observe(0, 38, standing());  // the replay lands at another tick
  for (std::uint32_t tick = 39; tick < 60; ++tick) flashes.observe(0, tick, standing());
  EXPECT_EQ(flashes.brightness(0, 38), 0);
  EXPECT_EQ(flashes.brightness(0, 40), 1);
  EXPECT_EQ(flashes.brightness(0, 41), 1 - 1.0 / PlayerFlashes::kTicks);
}

TEST(PlayerFlashes, AShortFallDoesNotFlash) {
  PlayerFlashes flashes;
  fall(flashes, 0, 10 + PlayerFlashes::kMinAirTicks - 1);
  EXPECT_EQ(flashes.brightness(0, 10 + PlayerFlashes::kMinAirTicks - 1), 0);
  PlayerFlashes others;
  fall(others, 0, 10 + PlayerFlashes::kMinAirTicks);
  EXPECT_EQ(others.brightness(0, 10 + PlayerFlashes::kMinAirTicks), 1);
}

TEST(PlayerFlashes, AFinishFlashesOnce) {
  PlayerFlashes flashes;
  PlayerState player = standing();
  flashes.observe(0, 1, player);
  player.finishTicks = 1;
  for (std::uint32_t tick = 2; tick < 100; ++tick) flashes.observe(0, tick, player);
  EXPECT_EQ(flashes.brightness(0, 2), 1);
  EXPECT_EQ(flashes.brightness(0, 50), 0);
}

TEST(PlayerFlashes, AnEarlierFinishDoesNotFlash) {
  PlayerFlashes flashes;
  PlayerState player = standing();
  player.finishTicks = 1;
  for (std::uint32_t tick = 300; tick < 330; ++tick) flashes.observe(0, tick, player);
  for (std::uint32_t tick = 300; tick < 330; ++tick) EXPECT_EQ(flashes.brightness(0, tick), 0) << tick;
}

// A viewer behind the newest tick sees each flash later.
TEST(PlayerFlashes, EachShowsAtItsOwnTick) {
  PlayerFlashes flashes;
  std::uint32_t tick = 0;
  for (int landing = 0; landing < 3; ++landing) {
    for (std::uint32_t air = 0; air < PlayerFlashes::kMinAirTicks; ++air) flashes.observe(0, ++tick, falling());
    flashes.observe(0, ++tick, standing());
  }
  for (std::uint32_t landing = 1; landing <= 3; ++landing) {
    EXPECT_EQ(flashes.brightness(0, landing * (PlayerFlashes::kMinAirTicks + 1)), 1) << landing;
    EXPECT_EQ(flashes.brightness(0, landing * (PlayerFlashes::kMinAirTicks + 1) - 1), 0) << landing;
  }
}

}  // namespace
}  // namespace platon::player_flashes_test
