#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "client/bot/button_presser.h"
#include "tests/net/support/session_network.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/test_levels.h"

namespace platon::resume_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 99;
constexpr std::size_t kDisconnected = 0;  // the client whose connection is lost

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };

Controls pressing(std::uint64_t seed) {
  return [presser = std::make_shared<ButtonPresser>(seed)](const Game&, std::uint32_t) { return presser->next(); };
}

// Runs to the right for two seconds of the round, then stands.
Controls settling() {
  return [](const Game& game, std::uint32_t) { return game.tick() < 120 ? Input{Input::kRight} : Input{}; };
}

struct ConnectionLoss {
  const char* what;
  double delayMs = 30;  // each way
  double lossPercent = 0;
  std::size_t players = 2;
  std::optional<Time> detectedAfter = seconds(3);  // time until the server detects it; nothing: never
  Time duration = seconds(6);
};

class Resume : public testing::TestWithParam<ConnectionLoss> {
 protected:
  void joinAll() {
    LinkQuality quality;
    quality.delayMs = GetParam().delayMs;
    quality.lossPercent = GetParam().lossPercent;
    match_.join(quality, settling());
    for (std::size_t i = 1; i < GetParam().players; ++i) match_.join(quality, pressing(kSeed + i));
    match_.tamper(kDisconnected, [this](std::vector<std::uint8_t>& bytes) {
      const auto message = decodeToClient(bytes);
      levelChunks_ += message && std::holds_alternative<LevelChunk>(*message) ? 1 : 0;
    });
  }

  // Disconnects the client and resumes its player. Returns the time from reconnecting to the first confirmed tick.
  Time disconnectAndResume(const std::function<void()>& meanwhile) {
    match_.disconnect(kDisconnected, GetParam().detectedAfter);
    meanwhile();
    const std::uint32_t before = match_.session(kDisconnected).predictionStatistics().confirmedTicks;
    const Time begun = match_.now();
    match_.resume(kDisconnected);
    while (match_.session(kDisconnected).predictionStatistics().confirmedTicks == before &&
           match_.now() < begun + seconds(20)) {
      match_.run(milliseconds(1));
    }
    return match_.now() - begun;
  }

  Time allowed() const {
    const Time roundTrip = milliseconds(static_cast<int>(2 * GetParam().delayMs));
    // With more than four players messages come every second tick, so a lost one costs two ticks.
    const int ticks = GetParam().lossPercent > 0 ? 9 : 3;
    return roundTrip + Time(ticks * 1'000'000 / kTicksPerSecond);
  }

  EntityState place() { return match_.match().game().world().entities()[match_.slot(kDisconnected)]; }

  // Checks all the while that the player stays present for the others.
  void runAndCheckPresence(Time duration) {
    const std::uint32_t slot = match_.slot(kDisconnected);
    for (const Time end = match_.now() + duration; match_.now() < end; match_.run(milliseconds(50))) {
      ASSERT_TRUE(match_.match().game().player(slot).present);
      ASSERT_EQ(match_.session(1).names()[slot], "someone");
      ASSERT_TRUE(match_.session(1).round()->prediction().confirmed().player(slot).present);
    }
  }

  SessionNetwork match_{{endlessLevel()}, kSeed};
  int levelChunks_ = 0;
};

TEST_P(Resume, ResumesThePlayerAtItsPlace) {
  joinAll();
  match_.run(seconds(5));
  const std::uint32_t slot = match_.slot(kDisconnected);
  const EntityState before = place();
  const std::uint32_t ticks = match_.session(kDisconnected).predictionStatistics().confirmedTicks;
  ASSERT_GT(ticks, 200u);
  levelChunks_ = 0;
  const Time took = disconnectAndResume([&] { runAndCheckPresence(GetParam().duration); });
  EXPECT_LE(took, allowed());
  RecordProperty("milliseconds", std::to_string(took / milliseconds(1)));
  std::printf("resumed after %lld ms\n", static_cast<long long>(took / milliseconds(1)));
  EXPECT_EQ(match_.slot(kDisconnected), slot);
  EXPECT_EQ(place().position, before.position);
  EXPECT_EQ(place().part, before.part);
  runAndCheckPresence(seconds(3));
  EXPECT_EQ(place().position, before.position);
  EXPECT_EQ(levelChunks_, 0);
  EXPECT_GT(match_.session(kDisconnected).predictionStatistics().confirmedTicks, ticks + 120);
  EXPECT_EQ(match_.session(kDisconnected).roundStatistics().desyncs, 0u);
  EXPECT_EQ(match_.session(kDisconnected).roundStatistics().resyncs, 0u);
  EXPECT_EQ(match_.match().players(), GetParam().players);
}

// The prediction is right from the first frame on.
TEST_P(Resume, PredictsThePlayerAtItsPlace) {
  joinAll();
  match_.run(seconds(5));
  const EntityState before = place();
  const PredictionStatistics count = match_.session(kDisconnected).predictionStatistics();
  disconnectAndResume([&] { match_.run(GetParam().duration); });
  const Prediction& prediction = match_.session(kDisconnected).round()->prediction();
  match_.run(milliseconds(4));  // to the first frame after the state has arrived
  for (const Time end = match_.now() + seconds(2); match_.now() < end; match_.run(milliseconds(1))) {
    ASSERT_LT(prediction.slot(), prediction.predicted().slots());
    ASSERT_TRUE(prediction.predicted().player(prediction.slot()).present);
    const EntityState& local = prediction.predicted().world().entities()[prediction.slot()];
    ASSERT_EQ(local.position, before.position);
    ASSERT_EQ(local.part, before.part);
  }
  const PredictionStatistics gained = match_.session(kDisconnected).predictionStatistics() - count;
  EXPECT_EQ(gained.missedInputs, 0u);
  EXPECT_EQ(gained.mispredicted, 0u);
  EXPECT_EQ(gained.corrections, 0u);
}

constexpr std::size_t kMany = hasSanitizers() ? 3 : 16;

INSTANTIATE_TEST_SUITE_P(
    Connections, Resume,
    testing::Values(ConnectionLoss{"Plain"},
                    ConnectionLoss{.what = "BeforeTheServerDetectsIt", .detectedAfter = std::nullopt},
                    ConnectionLoss{.what = "AtOnce", .detectedAfter = std::nullopt, .duration = milliseconds(100)},
                    ConnectionLoss{.what = "SixteenPlayers", .players = kMany},
                    ConnectionLoss{.what = "LongRoundTrip", .delayMs = 200},
                    ConnectionLoss{.what = "LongRoundTripLossesUndetected",
                                   .delayMs = 200,
                                   .lossPercent = 10,
                                   .players = kMany,
                                   .detectedAfter = std::nullopt},
                    ConnectionLoss{.what = "NearlyAMinute", .duration = seconds(62)}),
    [](const testing::TestParamInfo<ConnectionLoss>& test) { return test.param.what; });

class NextRound : public testing::Test {
 protected:
  static constexpr std::size_t kOther = 1;

  // Both players run to the goal of the first level.
  void startWith(double delayMs) {
    LinkQuality quality;
    quality.delayMs = delayMs;
    match_.join(quality, kRight);
    match_.join(quality, kRight);
    match_.run(milliseconds(1200));  // before the goal
    ASSERT_EQ(match_.match().round(), 1u);
  }

  void expectToPlay(std::uint32_t round) {
    match_.run(seconds(2));
    ASSERT_NE(match_.session(kDisconnected).round(), nullptr);
    EXPECT_EQ(match_.session(kDisconnected).round()->id(), round);
    EXPECT_TRUE(match_.session(kDisconnected).round()->prediction().present());
    EXPECT_TRUE(match_.match().game().player(match_.slot(kDisconnected)).present);
    EXPECT_EQ(match_.session(kDisconnected).roundStatistics().desyncs, 0u);
    EXPECT_EQ(match_.match().players(), 2u);
    const std::uint32_t missed = match_.session(kDisconnected).predictionStatistics().missedInputs;
    match_.run(seconds(1));
    EXPECT_EQ(match_.session(kDisconnected).predictionStatistics().missedInputs, missed);  // its inputs arrive in time
  }

  SessionNetwork match_{{flatLevel(), cornerLevel()}, kSeed};
};

TEST_F(NextRound, IsJoinedByAResumedPlayer) {
  startWith(40);
  const std::uint32_t slot = match_.slot(kDisconnected);
  match_.disconnect(kDisconnected, seconds(3));
  while (match_.match().round() == 1) match_.run(milliseconds(100));
  match_.run(milliseconds(800));
  ASSERT_EQ(match_.match().round(), 2u);
  EXPECT_EQ(match_.session(kOther).names()[slot], "someone");
  EXPECT_FALSE(match_.match().game().player(slot).present);  // a round starts with all players absent
  match_.resume(kDisconnected);
  expectToPlay(2);
  EXPECT_EQ(match_.slot(kDisconnected), slot);
  EXPECT_EQ(match_.session(kDisconnected).round()->prediction().confirmed().level().hash, cornerLevel()->hash);
}

// Interrupts the transfers of level, full state and round start at various points.
TEST_F(NextRound, IsJoinedAfterAnInterruptedTransfer) {
  for (int ms = 0; ms <= 400; ms += 20) {
    SCOPED_TRACE(ms);
    SessionNetwork match({flatLevel(), cornerLevel()}, kSeed + static_cast<std::uint64_t>(ms));
    LinkQuality quality;
    quality.delayMs = 60;
    match.join(quality, kRight);
    match.join(quality, kRight);
    match.run(milliseconds(6500 + ms));  // the second round starts meanwhile
    for (int again = 0; again < 4; ++again) {
      match.disconnect(kDisconnected, again % 2 == 0 ? std::optional<Time>(milliseconds(1)) : std::nullopt);
      match.run(milliseconds(7));
      match.resume(kDisconnected);
      match.run(milliseconds(ms));
    }
    match.run(seconds(4));
    ASSERT_NE(match.session(kDisconnected).round(), nullptr);
    EXPECT_EQ(match.session(kDisconnected).round()->id(), match.match().round());
    EXPECT_TRUE(match.session(kDisconnected).round()->prediction().present());
    EXPECT_EQ(match.slot(kDisconnected), 0u);
    EXPECT_EQ(match.match().players(), 2u);
    EXPECT_EQ(match.session(kDisconnected).roundStatistics().desyncs, 0u);
  }
}

}  // namespace
}  // namespace platon::resume_test
