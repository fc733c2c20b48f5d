// What players cost on the worst levels that are accepted. Prints the time and checks the memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "platon/game/game.h"
#include "tests/sim/button_presses.h"
#include "tests/support/counted_heap.h"
#include "tests/support/crowded_levels.h"
#include "tests/support/run/repetitions.h"

namespace platon::crowded_game_test {
namespace {

constexpr std::uint32_t kPlayers = 4;
const std::uint32_t kTicks = repetitions(2000u);
constexpr std::size_t kMaxBytesPerPlayer = 100 * 1024;

class CrowdedGameTest : public testing::TestWithParam<CrowdedLevel> {};

TEST_P(CrowdedGameTest, AFewMoreSegmentsWouldBeTooMany) {
  const LevelResult valid = loadLevel(GetParam().text(1));
  const auto error = std::find_if(valid.diagnostics.begin(), valid.diagnostics.end(),
                                  [](const Diagnostic& diagnostic) { return diagnostic.error; });
  ASSERT_NE(valid.level, nullptr) << format("level", *error);
  EXPECT_EQ(loadLevel(GetParam().text(1.05)).level, nullptr);
}

TEST_P(CrowdedGameTest, APlayerNeedsAtMostAHundredKilobytes) {
  using Clock = std::chrono::steady_clock;
  const std::shared_ptr<const Level> level = loadLevel(GetParam().text(1)).level;
  ASSERT_NE(level, nullptr);
  Game game(level);
  std::vector<sim::ButtonPresses> presses;
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) presses.emplace_back(3, slot);
  std::vector<Input> inputs(kPlayers);
  const std::size_t before = allocatedBytes();
  std::chrono::duration<double, std::micro> time{};
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    for (std::uint32_t slot = 0; slot < kPlayers; ++slot) inputs[slot] = presses[slot].next();
    if (tick % 200 == 199) inputs[0].buttons |= Input::kRestart;
    const auto begun = Clock::now();
    game.advance(inputs);
    time += Clock::now() - begun;
  }
  const std::size_t bytes = (allocatedBytes() - before) / kPlayers;
  std::printf("%s: %.1f us a player and tick, %zu KB a player\n", GetParam().name.c_str(),
              time.count() / (kTicks * kPlayers), (bytes + 1023) / 1024);
  EXPECT_LE(bytes, kMaxBytesPerPlayer);
}

INSTANTIATE_TEST_SUITE_P(All, CrowdedGameTest, testing::ValuesIn(crowdedLevels()),
                         [](const auto& level) { return level.param.name; });

}  // namespace
}  // namespace platon::crowded_game_test
