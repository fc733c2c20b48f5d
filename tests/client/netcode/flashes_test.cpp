#include "client/netcode/flashes.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

PlayerState standing() {
  PlayerState player;
  player.present = 1;
  player.ground = {0, PlayerState::kUnit};
  return player;
}

PlayerState falling() {
  PlayerState player;
  player.present = 1;
  return player;
}

// Stands, falls from tick 10 on, and lands in tick `landing`.
void fall(Flashes& flashes, std::uint32_t slot, std::uint32_t landing) {
  for (std::uint32_t tick = 1; tick < 10; ++tick) flashes.look(slot, tick, standing());
  for (std::uint32_t tick = 10; tick < landing; ++tick) flashes.look(slot, tick, falling());
  flashes.look(slot, landing, standing());
}

TEST(Flashes, ALandingShowsFromItsTickOnAndFades) {
  Flashes flashes;
  fall(flashes, 3, 40);
  EXPECT_EQ(flashes.at(3, 39.9), 0);
  EXPECT_EQ(flashes.at(3, 40), 1);
  EXPECT_DOUBLE_EQ(flashes.at(3, 40 + Flashes::kTicks / 2.0), 0.5);
  EXPECT_EQ(flashes.at(3, 40 + Flashes::kTicks), 0);
  EXPECT_EQ(flashes.at(2, 40), 0);
  EXPECT_EQ(flashes.at(9, 40), 0);
}

TEST(Flashes, AReplayRepeatsNothing) {
  Flashes flashes;
  fall(flashes, 0, 40);
  for (std::uint32_t tick = 30; tick < 38; ++tick) flashes.look(0, tick, falling());
  flashes.look(0, 38, standing());  // the replay lands elsewhere
  for (std::uint32_t tick = 39; tick < 60; ++tick) flashes.look(0, tick, standing());
  EXPECT_EQ(flashes.at(0, 38), 0);
  EXPECT_EQ(flashes.at(0, 40), 1);
  EXPECT_EQ(flashes.at(0, 41), 1 - 1.0 / Flashes::kTicks);
}

TEST(Flashes, AHopIsNoFall) {
  Flashes flashes;
  fall(flashes, 0, 10 + Flashes::kAirTicks - 1);
  EXPECT_EQ(flashes.at(0, 10 + Flashes::kAirTicks - 1), 0);
  Flashes others;
  fall(others, 0, 10 + Flashes::kAirTicks);
  EXPECT_EQ(others.at(0, 10 + Flashes::kAirTicks), 1);
}

TEST(Flashes, FinishingShowsOnce) {
  Flashes flashes;
  PlayerState player = standing();
  flashes.look(0, 1, player);
  player.finished = 1;
  for (std::uint32_t tick = 2; tick < 100; ++tick) flashes.look(0, tick, player);
  EXPECT_EQ(flashes.at(0, 2), 1);
  EXPECT_EQ(flashes.at(0, 50), 0);
}

TEST(Flashes, WhoHadFinishedBeforeIsNoNews) {
  Flashes flashes;
  PlayerState player = standing();
  player.finished = 1;
  for (std::uint32_t tick = 300; tick < 330; ++tick) flashes.look(0, tick, player);
  for (std::uint32_t tick = 300; tick < 330; ++tick) EXPECT_EQ(flashes.at(0, tick), 0) << tick;
}

// Who looks later than the newest tick sees each in its time.
TEST(Flashes, WaitForTheirTick) {
  Flashes flashes;
  std::uint32_t tick = 0;
  for (int landing = 0; landing < 3; ++landing) {
    for (std::uint32_t air = 0; air < Flashes::kAirTicks; ++air) flashes.look(0, ++tick, falling());
    flashes.look(0, ++tick, standing());
  }
  for (std::uint32_t landing = 1; landing <= 3; ++landing) {
    EXPECT_EQ(flashes.at(0, landing * (Flashes::kAirTicks + 1)), 1) << landing;
    EXPECT_EQ(flashes.at(0, landing * (Flashes::kAirTicks + 1) - 1), 0) << landing;
  }
}

}  // namespace
}  // namespace platon
