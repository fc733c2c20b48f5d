#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/state_difference.h"
#include "protocol/transfer.h"
#include "tests/net/support/input_flipper.h"
#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/flipped_bit.h"
#include "tests/support/test_levels.h"

namespace platon::desync_test {
namespace {

using std::chrono::seconds;

constexpr std::uint64_t kSeed = 77;

Controls standing() {
  return [](const Game&, std::uint32_t) { return Input{}; };
}

LinkQuality delayed(double delayMs) {
  LinkQuality quality;
  quality.delayMs = delayMs;
  quality.jitterMs = 5;
  return quality;
}

// The ticks that a summary names.
struct Ticks {
  unsigned desync = 0;
  unsigned match = 0;
  unsigned compared = 0;
};

Ticks ticksOf(const std::string& summary) {
  Ticks ticks;
  const int read =
      std::sscanf(summary.c_str(),
                  "round 1: desync at tick %u, last match at tick %u; first difference at tick %u: ", &ticks.desync,
                  &ticks.match, &ticks.compared);
  EXPECT_EQ(read, 3) << summary;
  return ticks;
}

void expectToVerify(const DesyncReport& report, std::uint32_t first) {
  const sim::Verification found = sim::Verifier(report.recording).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_EQ(found.firstTick, first);
}

// After its one desync the client has been resynced once and stays in lockstep.
void expectOneDesync(SessionNetwork& match, std::size_t client) {
  match.setChecked(client, true);
  match.run(seconds(20));
  EXPECT_EQ(match.session(client).roundStatistics().desyncs, 1u);
  EXPECT_EQ(match.session(client).roundStatistics().resyncs, 1u);
  EXPECT_FALSE(match.takeDesync(client).has_value());
  EXPECT_TRUE(match.session(client).round()->prediction().present());
  EXPECT_EQ(match.count(MatchEvent::Kind::kDesync), 1u);
}

/// Flips a bit in the first full state sent to the client.
struct StateFlipper {
  std::string owner;
  std::string field;
  std::optional<std::uint32_t> tick;  // of that state
  std::string original;
  std::string flipped;  // value of the field

  void operator()(std::vector<std::uint8_t>& bytes) {
    auto message = decodeToClient(bytes);
    auto* chunk = message ? std::get_if<StateChunk>(&*message) : nullptr;
    if (chunk == nullptr || tick) return;
    auto state = decodeFullState(chunk->bytes);
    Game game(endlessLevel());
    ASSERT_TRUE(state && game.restore(state->game));
    state->game = flippedBit(game, owner, field);
    Game other(endlessLevel());
    ASSERT_TRUE(other.restore(state->game));
    const auto difference = firstDifference(game, other);
    tick = chunk->tick;
    original = difference->left;
    flipped = difference->right;
    chunk->bytes = encode(*state);
    bytes = encode(*chunk);
  }
};

struct Flipped {
  const char* owner;  // without the slot number
  const char* field;
};

class FlippedField : public testing::TestWithParam<Flipped> {};

// The field of a player that stands still, so that it keeps its value until the games are compared.
TEST_P(FlippedField, IsReportedAndResynced) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(delayed(10), pressing(kSeed));
  match.join(delayed(10), standing());
  match.run(seconds(15));
  const auto flipper = std::make_shared<StateFlipper>();
  flipper->owner = GetParam().owner + std::to_string(match.slot(1));
  flipper->field = GetParam().field;
  match.join(delayed(60), pressing(kSeed + 1));
  match.setChecked(2, false);
  match.tamper(2, [flipper](std::vector<std::uint8_t>& bytes) { (*flipper)(bytes); });
  match.run(seconds(4));
  const auto report = match.takeDesync(2);
  ASSERT_TRUE(report.has_value());
  const Ticks ticks = ticksOf(report->summary);
  ASSERT_TRUE(flipper->tick.has_value());
  EXPECT_EQ(ticks.match, *flipper->tick);
  EXPECT_GT(ticks.desync, ticks.match);
  EXPECT_LE(ticks.desync, ticks.match + 30);  // one round trip
  EXPECT_GE(ticks.compared, ticks.match + ClientTransfers::kTicksBetweenStates);
  EXPECT_LE(ticks.compared, ticks.match + ClientTransfers::kTicksBetweenStates + 30);
  EXPECT_TRUE(report->summary.ends_with(": " + flipper->field + " of " + flipper->owner + " is " + flipper->flipped +
                                        " on the client, " + flipper->original + " on the server"))
      << report->summary;
  expectToVerify(*report, *flipper->tick);
  expectOneDesync(match, 2);
}

INSTANTIATE_TEST_SUITE_P(Fields, FlippedField,
                         testing::Values(Flipped{"entity ", "position"}, Flipped{"player ", "finishTicks"}),
                         [](const testing::TestParamInfo<Flipped>& test) { return test.param.field; });

TEST(Desync, AWrongInputIsReportedAndResynced) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(delayed(10), pressing(kSeed));
  match.join(delayed(60), pressing(kSeed + 1));
  match.run(seconds(5));
  const auto flipper = std::make_shared<InputFlipper>();
  flipper->from = match.match().game().tick();
  flipper->slot = static_cast<std::uint8_t>(match.slot(0));
  match.setChecked(1, false);
  match.tamper(1, [flipper](std::vector<std::uint8_t>& bytes) { (*flipper)(bytes); });
  match.run(seconds(4));
  const auto report = match.takeDesync(1);
  ASSERT_TRUE(report.has_value());
  const Ticks ticks = ticksOf(report->summary);
  ASSERT_TRUE(flipper->tick.has_value());
  EXPECT_LE(ticks.match, *flipper->tick);
  EXPECT_GE(ticks.match + 10, *flipper->tick);
  EXPECT_GT(ticks.desync, *flipper->tick);
  EXPECT_LE(ticks.desync, *flipper->tick + 10);
  EXPECT_LE(ticks.compared, *flipper->tick + 30);
  EXPECT_NE(report->summary.find(" of entity " + std::to_string(flipper->slot) + " is "), std::string::npos)
      << report->summary;
  expectToVerify(*report, 3);  // the tick of the state with which it joined
  expectOneDesync(match, 1);
}

// The full state never arrives, as if the session ended earlier.
void expectReportAtTheEnd(const std::function<void(SessionNetwork&)>& end) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(delayed(10), pressing(kSeed));
  match.setChecked(0, false);
  const auto flipper = std::make_shared<InputFlipper>(InputFlipper{60, 0, {}});
  match.tamper(0, [flipper](std::vector<std::uint8_t>& bytes) {
    (*flipper)(bytes);
    const auto message = decodeToClient(bytes);
    if (message && std::holds_alternative<StateChunk>(*message)) bytes = encode(Roster());
  });
  match.run(seconds(4));
  EXPECT_FALSE(match.takeDesync(0).has_value());
  end(match);
  match.run(seconds(1));
  const auto report = match.takeDesync(0);
  ASSERT_TRUE(report.has_value());
  EXPECT_TRUE(report->summary.ends_with("; the server's state did not arrive")) << report->summary;
  expectToVerify(*report, 0);
}

TEST(Desync, WithoutAResyncIsReportedAtTheEndOfTheSession) {
  expectReportAtTheEnd([](SessionNetwork& match) { match.match().stop("enough"); });
  expectReportAtTheEnd([](SessionNetwork& match) { match.session(0).leave(); });
  expectReportAtTheEnd([](SessionNetwork& match) { match.session(0).connectionLost("gone"); });
}

TEST(Desync, RepeatedDesyncsAreReportedOnceAMinute) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(delayed(10), pressing(kSeed));
  match.setChecked(0, false);
  match.tamper(0, [](std::vector<std::uint8_t>& bytes) {
    auto message = decodeToClient(bytes);
    if (auto* ticks = message ? std::get_if<ConfirmedTicks>(&*message) : nullptr) {
      for (InputChange& change : ticks->changes) change.input.buttons ^= Input::kLeft;
      bytes = encode(*ticks);
    }
  });
  int reports = 0;
  for (int second = 0; second < 130; ++second) {
    match.run(seconds(1));
    reports += match.takeDesync(0) ? 1 : 0;
  }
  EXPECT_EQ(reports, 3);
  EXPECT_GT(match.session(0).roundStatistics().desyncs, 60u);
}

}  // namespace
}  // namespace platon::desync_test
