#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "client/bot/button_presser.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/net/support/session_network.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/test_levels.h"

namespace platon::long_session_test {
namespace {

using std::chrono::seconds;

constexpr std::uint64_t kSeed = 4711;
constexpr std::uint32_t kBots = 8;

// Random buttons, and now and then a restart and a run to the goal, so that rounds end on levels where it is reachable.
Controls pressing(std::uint64_t seed) {
  return [presser = std::make_shared<ButtonPresser>(seed)](const Game& game, std::uint32_t) {
    const std::uint32_t phase = game.tick() % 1500;
    if (phase < 700) return presser->next();
    if (phase < 710) return Input{Input::kRestart};
    const bool jumps = phase / 20 % 2 == 0;
    return Input{static_cast<std::uint8_t>(Input::kRight | (jumps ? Input::kJump : 0))};
  };
}

// Network conditions from good to hardly playable.
LinkQuality qualityOf(std::uint32_t number) {
  LinkQuality quality;
  quality.delayMs = 5 + 20 * number;
  quality.jitterMs = 10 * number;
  quality.lossPercent = 2 * number;
  quality.duplicatePercent = number;
  quality.reorderPercent = number;
  return quality;
}

// Over many rounds and levels, under all conditions.
TEST(LongSession, DetectsNoDesyncWithoutACause) {
  const auto wanted = static_cast<std::uint64_t>(step_check::runLength(100000, 1000000));
  SessionNetwork match({flatLevel(), cornerLevel(), endlessLevel()}, kSeed);
  for (std::uint32_t bot = 0; bot < kBots; ++bot) {
    match.join(qualityOf(bot), pressing(kSeed + bot));
    match.run(seconds(2 * bot));  // late joiners need a full state
  }
  std::uint64_t ticks = 0;
  for (; ticks < wanted && !HasFatalFailure(); match.run(seconds(10))) {
    ticks = 0;
    for (std::uint32_t bot = 0; bot < kBots; ++bot) ticks += match.session(bot).predictionStatistics().confirmedTicks;
  }
  for (std::uint32_t bot = 0; bot < kBots; ++bot) {
    SCOPED_TRACE("bot " + std::to_string(bot) + ", seed " + std::to_string(kSeed));
    EXPECT_EQ(match.session(bot).roundStatistics().desyncs, 0u);
    EXPECT_FALSE(match.takeDesync(bot).has_value());
  }
  for (const MatchEvent& event : match.events()) {
    EXPECT_NE(event.kind, MatchEvent::Kind::kDesync) << event.text;
  }
  std::printf("%llu ticks of %u bots in %u rounds\n", static_cast<unsigned long long>(ticks), kBots,
              match.match().round());
}

}  // namespace
}  // namespace platon::long_session_test
