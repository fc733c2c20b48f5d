#include "client/desync/recent_recording.h"

#include <gtest/gtest.h>

#include "tests/sim/verify/verification.h"
#include "tests/support/test_level.h"

namespace platon::recent_recording_test {
namespace {

constexpr std::uint32_t kBlock = RecentRecording::kTicksBetweenCheckpoints;

void play(Game& game, RecentRecording& recording, std::uint32_t ticks) {
  for (std::uint32_t i = 0; i < ticks; ++i) {
    const Input input = validInput(static_cast<std::uint8_t>(Input::kPresent | game.tick() / 20 % 8));
    game.advance({&input, 1});
    recording.record({&input, 1}, game);
  }
}

sim::Verification verified(const std::vector<std::uint8_t>& bytes) {
  const sim::Verification found = sim::Verifier(bytes).run();
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_EQ(found.fault, "");
  return found;
}

TEST(RecentRecording, ContainsTheWholeGameWhileItIsShort) {
  for (const std::uint32_t ticks : {0u, 1u, kBlock - 1, kBlock, 2 * kBlock + 17}) {
    Game game(endlessLevel());
    RecentRecording recording(game);
    play(game, recording, ticks);
    const sim::Verification found = verified(recording.finish(game));
    EXPECT_EQ(found.firstTick, 0u);
    EXPECT_EQ(found.ticks, ticks);
    EXPECT_EQ(found.hash, game.hash());
  }
}

TEST(RecentRecording, DropsTheOldestTicksBeyondItsSizeLimit) {
  constexpr std::uint32_t kTicks = 200000;
  Game game(endlessLevel());
  RecentRecording recording(game);
  play(game, recording, kTicks);
  const std::vector<std::uint8_t> bytes = recording.finish(game);
  EXPECT_LT(bytes.size(), RecentRecording::kMaxBytes + 3 * kBlock * sizeof(std::uint64_t));
  EXPECT_GT(bytes.size(), RecentRecording::kMaxBytes / 2);
  const sim::Verification found = verified(bytes);
  EXPECT_GT(found.firstTick, 0u);
  EXPECT_EQ(found.firstTick + found.ticks, kTicks);
  EXPECT_EQ(found.hash, game.hash());
}

}  // namespace
}  // namespace platon::recent_recording_test
