#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/state_difference.h"
#include "protocol/full_state.h"
#include "tests/sim/verification.h"
#include "tests/support/flipped_bit.h"
#include "tests/support/input_flipper.h"
#include "tests/support/pressing.h"
#include "tests/support/test_level.h"
#include "tests/support/virtual_match.h"

namespace platon {
namespace {

using std::chrono::seconds;

constexpr std::uint64_t kSeed = 77;

Controls standing() {
  return [](const Game&, std::uint32_t) { return Input{}; };
}

LinkQuality delayed(double delayMs) {
  LinkQuality line;
  line.delayMs = delayMs;
  line.jitterMs = 5;
  return line;
}

// The ticks that a report names.
struct Ticks {
  unsigned wrong = 0;
  unsigned right = 0;
  unsigned compared = 0;
};

Ticks ticksOf(const std::string& summary) {
  Ticks ticks;
  const int read = std::sscanf(summary.c_str(),
                               "round 1: the game was not the server's after tick %u, and was after tick %u; after "
                               "tick %u the first field",
                               &ticks.wrong, &ticks.right, &ticks.compared);
  EXPECT_EQ(read, 3) << summary;
  return ticks;
}

void expectToVerify(const DesyncReport& report, std::uint32_t first) {
  const sim::Verification found = sim::Verifier(report.recording).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_EQ(found.firstTick, first);
}

// One client, which has been told a wrong thing, is put right once and stays in step for ever after.
void expectOneMismatch(VirtualMatch& match, std::size_t client) {
  match.setChecked(client, true);
  match.run(seconds(20));
  EXPECT_EQ(match.session(client).roundStatistics().desyncs, 1u);
  EXPECT_EQ(match.session(client).roundStatistics().resyncs, 1u);
  EXPECT_FALSE(match.takeDesync(client).has_value());
  EXPECT_TRUE(match.session(client).round()->prediction().present());
  std::size_t told = 0;
  for (const MatchEvent& event : match.match().takeEvents()) told += event.kind == MatchEvent::Kind::kDesync ? 1 : 0;
  EXPECT_EQ(told, 1u);
}

/// Flips a bit of the first full state that passes.
struct StateFlipper {
  std::string owner;
  std::string field;
  std::optional<std::uint32_t> tick;  // of the state
  std::string was, is;                // value of the field

  void operator()(std::vector<std::uint8_t>& bytes) {
    auto message = decodeToClient(bytes);
    auto* chunk = message ? std::get_if<StateChunk>(&*message) : nullptr;
    if (chunk == nullptr || tick) return;
    auto state = decodeFullState(chunk->bytes);
    Game game(endlessLevel());
    ASSERT_TRUE(state && game.restore(state->game));
    state->game = flippedBit(game, owner, field);
    Game flipped(endlessLevel());
    ASSERT_TRUE(flipped.restore(state->game));
    const auto difference = firstDifference(game, flipped);
    tick = chunk->tick;
    was = difference->left;
    is = difference->right;
    chunk->bytes = encode(*state);
    bytes = encode(*chunk);
  }
};

struct Flipped {
  const char* owner;  // with the slot behind
  const char* field;
};

class FlippedField : public testing::TestWithParam<Flipped> {};

// Of a player that stands still, so that the field stays what it is until both games are compared.
TEST_P(FlippedField, IsFoundNamedAndPutRight) {
  VirtualMatch match({endlessLevel()}, kSeed);
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
  EXPECT_EQ(ticks.right, *flipper->tick);
  EXPECT_GT(ticks.wrong, ticks.right);
  EXPECT_LE(ticks.wrong, ticks.right + 30);  // one round trip
  EXPECT_GE(ticks.compared, ticks.right + MatchPlayer::kTicksBetweenStates);
  EXPECT_LE(ticks.compared, ticks.right + MatchPlayer::kTicksBetweenStates + 30);
  EXPECT_TRUE(report->summary.ends_with("is " + flipper->field + " of " + flipper->owner + ": " + flipper->is +
                                        " here, " + flipper->was + " on the server"))
      << report->summary;
  expectToVerify(*report, *flipper->tick);
  expectOneMismatch(match, 2);
}

INSTANTIATE_TEST_SUITE_P(Fields, FlippedField,
                         testing::Values(Flipped{"entity ", "position"}, Flipped{"player ", "finishedAt"}),
                         [](const testing::TestParamInfo<Flipped>& test) { return test.param.field; });

TEST(Desync, WrongInputIsFoundNamedAndPutRight) {
  VirtualMatch match({endlessLevel()}, kSeed);
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
  EXPECT_LE(ticks.right, *flipper->tick);
  EXPECT_GE(ticks.right + 10, *flipper->tick);
  EXPECT_GT(ticks.wrong, *flipper->tick);
  EXPECT_LE(ticks.wrong, *flipper->tick + 10);
  EXPECT_LE(ticks.compared, *flipper->tick + 30);
  EXPECT_NE(report->summary.find(" of entity " + std::to_string(flipper->slot) + ": "), std::string::npos)
      << report->summary;
  expectToVerify(*report, 3);  // the state it joined with: its Hello took 50 ms longer than the first one's
  expectOneMismatch(match, 1);
}

// The state is lost for good, which the transport below would not let happen but for the end of the session.
void expectReportAtTheEnd(const std::function<void(VirtualMatch&)>& end) {
  VirtualMatch match({endlessLevel()}, kSeed);
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
  EXPECT_TRUE(report->summary.ends_with("; the server's state has not come, so that no field can be named"))
      << report->summary;
  expectToVerify(*report, 0);
}

TEST(Desync, ThatIsNeverPutRightIsReportedAtTheEnd) {
  expectReportAtTheEnd([](VirtualMatch& match) { match.match().stop("enough"); });
  expectReportAtTheEnd([](VirtualMatch& match) { match.session(0).leave(); });
  expectReportAtTheEnd([](VirtualMatch& match) { match.session(0).lose("gone"); });
}

// A server that lies can make a client report once a minute at most.
TEST(Desync, ThatComesAgainAndAgainIsReportedOnceAMinute) {
  VirtualMatch match({endlessLevel()}, kSeed);
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
}  // namespace platon
