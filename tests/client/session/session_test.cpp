#include "client/session/session.h"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/netcode/player_watch.h"
#include "client/netcode/prediction.h"
#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"

namespace platon::session_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 20240607;

LinkQuality qualityOf(double delayMs, double jitterMs = 0, double loss = 0) {
  LinkQuality quality;
  quality.delayMs = delayMs;
  quality.jitterMs = jitterMs;
  quality.lossPercent = loss;
  return quality;
}

// Statistics gained during a run.
struct Gain {
  PredictionStatistics prediction;
  std::uint32_t jumps = 0;
};

Gain gainOf(SessionNetwork& match, std::size_t client, Time duration) {
  const PredictionStatistics before = match.session(client).predictionStatistics();
  const std::uint32_t jumps = match.session(client).round()->clock().jumps();
  match.run(duration);
  const PredictionStatistics after = match.session(client).predictionStatistics();
  return {{after.corrections - before.corrections, after.maxSubunits, 0, after.missedInputs - before.missedInputs,
           after.mispredicted - before.mispredicted, after.confirmedTicks - before.confirmedTicks},
          match.session(client).round()->clock().jumps() - jumps};
}

class ConstantDelay : public testing::TestWithParam<double> {};

// Up to a round trip of 2 s.
TEST_P(ConstantDelay, NeedsNoCorrection) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(qualityOf(GetParam()), pressing(kSeed));
  match.join(qualityOf(20), pressing(kSeed + 1));
  match.run(seconds(12));
  const Gain gain = gainOf(match, 0, seconds(10));
  EXPECT_GT(gain.prediction.confirmedTicks, 590u);
  EXPECT_EQ(gain.prediction.missedInputs, 0u);
  EXPECT_EQ(gain.prediction.corrections, 0u);
  EXPECT_EQ(gain.prediction.mispredicted, 0u);
  EXPECT_EQ(gain.jumps, 0u);
  EXPECT_EQ(match.session(0).roundStatistics().desyncs, 0u);
  EXPECT_EQ(match.session(0).roundStatistics().resyncs, 0u);
}

INSTANTIATE_TEST_SUITE_P(RoundTrips, ConstantDelay, testing::Values(0.0, 25.0, 100.0, 400.0, 1000.0));

TEST(Session, StaysInLockstepUnderLossAndJitter) {
  SessionNetwork match({endlessLevel()}, kSeed);
  LinkQuality quality = qualityOf(60, 40, 10);
  quality.duplicatePercent = 5;
  quality.reorderPercent = 5;
  for (std::uint64_t i = 0; i < 3; ++i) match.join(quality, pressing(kSeed + i));
  match.run(seconds(10));
  const Gain gain = gainOf(match, 1, seconds(20));
  EXPECT_GT(gain.prediction.confirmedTicks, 1150u);
  // The buttons change about four times a second. About one change in a hundred is lost together with its
  // repetition and costs a few ticks.
  EXPECT_LT(gain.prediction.missedInputs, 60u);
  EXPECT_EQ(match.session(1).roundStatistics().desyncs, 0u);
  EXPECT_EQ(match.session(1).roundStatistics().resyncs, 0u);
}

TEST(Session, ALateJoinerPlaysTheRunningRound) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(qualityOf(30), pressing(kSeed));
  match.run(seconds(40));
  match.join(qualityOf(80), pressing(kSeed + 1));
  match.run(seconds(3));
  const Gain gain = gainOf(match, 1, seconds(5));
  EXPECT_TRUE(match.session(1).round()->prediction().present());
  EXPECT_GT(gain.prediction.confirmedTicks, 290u);
  EXPECT_EQ(gain.prediction.missedInputs, 0u);
  EXPECT_EQ(match.session(1).roundStatistics().desyncs, 0u);
}

TEST(Session, HandsOnTheNewestNotice) {
  SessionNetwork network({endlessLevel()}, kSeed);
  network.join(qualityOf(30), pressing(kSeed));
  network.run(seconds(1));
  EXPECT_EQ(network.session(0).takeNotice(), std::nullopt);
  network.match().say("restart at noon");
  network.match().say("restart at one");
  network.run(seconds(1));
  EXPECT_EQ(network.session(0).takeNotice(), "restart at one");
  EXPECT_EQ(network.session(0).takeNotice(), std::nullopt);
}

TEST(Session, PlaysTheNextRound) {
  SessionNetwork match({flatLevel(), cornerLevel()}, kSeed);
  const Controls right = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };
  match.join(qualityOf(40), right);
  match.join(qualityOf(10), right);
  match.run(seconds(15));
  for (const std::size_t client : {0u, 1u}) {
    ASSERT_NE(match.session(client).round(), nullptr);
    EXPECT_GT(match.session(client).round()->id(), 1u);
    EXPECT_EQ(match.session(client).round()->prediction().confirmed().level().hash, cornerLevel()->hash);
    EXPECT_TRUE(match.session(client).round()->prediction().present());
  }
}

TEST(Session, SlowFramesCauseNoMissedInputs) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.setFrame(milliseconds(100));
  match.join(qualityOf(20), pressing(kSeed));
  match.run(seconds(12));
  const Gain gain = gainOf(match, 0, seconds(10));
  EXPECT_EQ(gain.prediction.missedInputs, 0u);
  EXPECT_EQ(gain.prediction.corrections, 0u);
}

// Single frames of half a second are no jitter of the connection.
TEST(Session, AStallDoesNotIncreaseTheLead) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(qualityOf(20), pressing(kSeed));
  match.run(seconds(12));
  const Round& round = *match.session(0).round();
  const double lead = round.clock().lead();
  for (int stall = 0; stall < 8; ++stall) {
    match.setFrame(milliseconds(500));
    match.run(milliseconds(500));
    match.setFrame(milliseconds(4));
    match.run(milliseconds(700));
  }
  match.run(seconds(1));
  EXPECT_LT(round.clock().lead(), lead + 1);
}

TEST(Session, KeepsTheRoster) {
  SessionNetwork match({endlessLevel()}, kSeed);
  match.join(qualityOf(5), pressing(kSeed));
  match.join(qualityOf(5), pressing(kSeed));
  match.run(seconds(1));
  const auto names = match.session(0).names();
  ASSERT_EQ(names.size(), 16u);
  EXPECT_EQ(names[match.slot(0)], "someone");
  EXPECT_EQ(names[match.slot(1)], "someone 2");
  EXPECT_EQ(names[5], "");
}

TEST(Session, ShowsOnlyVisibleCharactersOfTheServersTexts) {
  Session session("x", Time(0));
  session.receive(encode(Welcome{0, 1, 2, 4, kTicksPerSecond, ""}), Time(0));
  session.receive(encode(Roster{{{1, " A\u200bnn "}, {2, "\u3164"}}}), Time(0));
  EXPECT_EQ(session.names()[1], "Ann");
  EXPECT_EQ(session.names()[2], "");
  session.receive(encode(Bye{ByeCode::kServerStops, "\u3164 why"}), Time(0));
  ASSERT_TRUE(session.ending().has_value());
  EXPECT_EQ(session.ending()->reason, "the server ended the game: why");
}

TEST(Session, ARoundIsOverWhenTheServerEndsIt) {
  Session::Memory memory;
  memory.levels = {endlessLevel()};
  Session session("x", Time(0), memory);
  const std::uint64_t level = endlessLevel()->hash;
  session.receive(encode(Welcome{0, 1, level, 4, kTicksPerSecond, ""}), Time(0));
  session.receive(encode(RoundEnd{7, 10, level}), Time(0));
  EXPECT_FALSE(session.roundEnd()) << "another round";
  session.receive(encode(RoundEnd{1, 10, level}), Time(0));
  EXPECT_TRUE(session.roundEnd());
  session.receive(encode(RoundStart{2, level}), Time(0));
  EXPECT_FALSE(session.roundEnd());
}

TEST(Session, CountsTheDesyncsOfAllRounds) {
  Session::Memory memory;
  memory.levels = {endlessLevel()};
  Session session("x", Time(0), memory);
  const std::uint64_t level = endlessLevel()->hash;
  session.receive(encode(Welcome{0, 1, level, 4, kTicksPerSecond, ""}), Time(0));
  for (std::uint32_t round = 1; round <= 3; ++round) {
    session.receive(encode(ConfirmedTicks{round, 0, 1, 12345, std::nullopt, {}}), Time(0));
    session.receive(encode(RoundStart{round + 1, level}), Time(0));
  }
  EXPECT_EQ(session.roundStatistics().desyncs, 3u);
  EXPECT_EQ(session.predictionStatistics().confirmedTicks, 3u);
}

// Levels that differ in their titles.
std::shared_ptr<const Level> levelOfNumber(std::size_t number) {
  return loadLevel("# title: " + std::to_string(number) + "\n" + std::string(endlessLevel()->text)).level;
}

void receiveLevel(Session& session, const Level& level) {
  const std::vector<std::uint8_t> text(level.text.begin(), level.text.end());
  session.receive(encode(LevelChunk{level.hash, static_cast<std::uint32_t>(text.size()), 0, text}), Time(0));
}

// A level that comes makes good for its request, so no rotation is too long.
TEST(Session, PlaysAnyNumberOfLevelsThatTheServerSends) {
  Session session("x", Time(0));
  constexpr std::uint32_t kLevels = 2 * KnownLevels::kMaxUnansweredRequests;
  for (std::uint32_t number = 1; number <= kLevels; ++number) {
    const std::shared_ptr<const Level> level = levelOfNumber(number);
    if (number == 1)
      session.receive(encode(Welcome{0, 1, level->hash, 4, kTicksPerSecond, ""}), Time(0));
    else
      session.receive(encode(RoundStart{number, level->hash}), Time(0));
    receiveLevel(session, *level);
    ASSERT_FALSE(session.ending().has_value()) << number << ": " << session.ending()->reason;
    ASSERT_TRUE(session.round());
    EXPECT_EQ(session.round()->id(), number);
  }
}

TEST(Session, EndsOnRoundStartBeforeWelcome) {
  Session session("x", Time(0));
  session.receive(encode(RoundStart{1, 2}), Time(0));
  EXPECT_TRUE(session.ending().has_value());
}

TEST(Session, EndsIfTheServerNamesLevelsWithoutSendingThem) {
  Session session("x", Time(0));
  session.receive(encode(Welcome{0, 1, 1, 4, kTicksPerSecond, ""}), Time(0));
  for (std::uint32_t i = 1; i <= KnownLevels::kMaxUnansweredRequests; ++i) {
    session.receive(encode(RoundStart{1 + i, 1 + i}), Time(0));
    ASSERT_FALSE(session.ending().has_value());
  }
  session.receive(encode(RoundStart{100, 100}), Time(0));
  ASSERT_TRUE(session.ending().has_value());
  EXPECT_EQ(session.ending()->reason, "protocol error: the server names levels that it does not send");
}

TEST(Session, TimesOutWhenTheServerIsSilent) {
  Session session("x", Time(0));
  const Controls none = [](const Game&, std::uint32_t) { return Input{}; };
  session.receive(encode(Welcome{0, 1, 2, 4, kTicksPerSecond, ""}), Time(0));
  session.update(Session::kTimeout, none);
  EXPECT_FALSE(session.ending().has_value());
  session.update(Session::kTimeout + milliseconds(1), none);
  ASSERT_TRUE(session.ending().has_value());
  EXPECT_FALSE(session.ending()->permanent);
}

// A game is computed again at every start of a round.
TEST(Session, EndsIfTheServerDemandsTooMuchComputation) {
  constexpr std::uint32_t kRoundWork = 64;
  constexpr auto kBudget = static_cast<std::uint32_t>(WorkLimit::kMaxPerSecond * toSeconds(WorkLimit::kTime));
  constexpr std::uint32_t kRounds = kBudget / kRoundWork;
  const Controls none = [](const Game&, std::uint32_t) { return Input{}; };
  Session::Memory memory;
  memory.levels.push_back(endlessLevel());
  const std::uint64_t level = memory.levels[0]->hash;
  Session session("x", Time(0), memory);
  session.receive(encode(Welcome{0, 1, level, 4, kTicksPerSecond, ""}), Time(0));
  for (std::uint32_t round = 2; round <= kRounds; ++round) session.receive(encode(RoundStart{round, level}), Time(0));
  session.update(Time(0), none);
  ASSERT_FALSE(session.ending().has_value());  // the budget is empty
  session.receive(encode(RoundStart{kRounds + 1, level}), Time(0));
  session.update(Time(0), none);
  ASSERT_TRUE(session.ending().has_value());
  EXPECT_EQ(session.ending()->reason, "protocol error: the server demands more computation than a game needs");
  EXPECT_TRUE(session.ending()->permanent);
}

// Sends a session as many ticks before each update as it takes. Returns for how many updates it bears that.
int updatesUntilEnd(Time interval, int updates) {
  const Controls none = [](const Game&, std::uint32_t) { return Input{}; };
  Session::Memory memory;
  memory.levels.push_back(endlessLevel());
  Session session("x", Time(0), memory);
  session.receive(encode(Welcome{0, 1, memory.levels[0]->hash, 4, kTicksPerSecond, ""}), Time(0));
  for (int update = 1; update <= updates; ++update) {
    const Time now = update * interval;
    session.update(now, none);
    if (session.ending()) return update;
    std::uint32_t tick = session.round()->prediction().confirmedTicks();
    for (int i = 0; i < 20; ++i, tick += kMaxTicksPerMessage) {
      session.receive(encode(ConfirmedTicks{1, tick, kMaxTicksPerMessage, 0, {}, {}}), now);
    }
  }
  return 0;
}

TEST(Session, LeavesAServerWhoseGameIsTooSlowOnThisComputer) {
  EXPECT_EQ(updatesUntilEnd(milliseconds(250), 100), 0);
  EXPECT_EQ(updatesUntilEnd(milliseconds(300), 100), 1 + 17);  // 5.1 s after the first ticks
  EXPECT_EQ(updatesUntilEnd(milliseconds(2000), 100), 1 + 6);  // each counts as 1 s
}

// Notes when the player of slot 0 begins to press restart, and on how many edges it has been since.
class RestartObserver : public ConfirmedObserver {
 public:
  void began(const Game&, std::uint32_t) override {}
  void advanced(std::span<const Input> inputs, const Game& game) override {
    const bool presses = !inputs.empty() && inputs[0].has(Input::kRestart);
    if (presses) ++ticks;
    if (presses && !presses_) {
      crossings.push_back(crossings_);
      isAtStart.push_back(game.world().entities()[0].part == game.level().startFace);
    }
    presses_ = presses;
    if (game.slots() > 0) crossings_ = game.world().entities()[0].crossings;
  }

  std::vector<std::uint32_t> crossings;  // before each restart
  std::vector<bool> isAtStart;           // after it
  std::uint32_t ticks = 0;               // in which restart is pressed

 private:
  std::uint32_t crossings_ = 0;
  bool presses_ = false;
};

// A cube without a floor: round it once is four edges. The server decides what the client has pressed, so it is
// recorded as any input.
TEST(Session, AfterTheThirdLapOfAFallTheClientPressesRestart) {
  const LevelResult level = loadLevel("HEXAHEDRON\n0 0 0 0\n4 200 200\n480\n%\n%\n%\n%\n%\n%\n");
  ASSERT_TRUE(level.level);
  SessionNetwork match({level.level}, kSeed);
  const auto observer = std::make_shared<RestartObserver>();
  match.join(
      qualityOf(50), [](const Game&, std::uint32_t) { return Input{}; }, observer);
  match.run(seconds(16));
  EXPECT_TRUE(observer->crossings.empty());
  match.run(seconds(29));
  EXPECT_EQ(observer->isAtStart, std::vector<bool>({true, true}));
  ASSERT_EQ(observer->crossings.size(), 2u);
  EXPECT_EQ(observer->crossings[0], 12u);
  EXPECT_EQ(observer->ticks, 2 * EndlessFall::kRestartTicks) << "so that one late input does not lose it";
}

}  // namespace
}  // namespace platon::session_test
