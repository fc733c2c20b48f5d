#include "client/desync/desync_detector.h"

#include <gtest/gtest.h>

#include "platon/game/state_difference.h"
#include "protocol/limits.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/flipped_bit.h"
#include "tests/support/test_levels.h"

namespace platon::desync_detector_test {
namespace {

constexpr std::uint32_t kMatchingTicks = 100;  // ticks for which both games match
constexpr Input kStands{Input::kPresent};
constexpr Input kRuns{Input::kPresent | Input::kRight};

/// A server's game, and a client's game that a flipped bit makes different.
class DesyncDetectorTest : public testing::Test {
 protected:
  DesyncDetectorTest() {
    play(kMatchingTicks);
    detector_.hashMatched(client_);
  }

  void playServer(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks; ++i) server_.advance(inputs_);
  }
  void playClient(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks; ++i) {
      client_.advance(inputs_);
      detector_.advanced(inputs_, client_);
    }
  }
  void play(std::uint32_t ticks) {
    playServer(ticks);
    playClient(ticks);
  }

  // Flips a bit in the client's game, plays three ticks and compares hashes.
  void desync() {
    ASSERT_TRUE(client_.restore(flippedBit(client_, "entity 0", "position")));
    play(3);
    ASSERT_NE(client_.hash(), server_.hash());
    detector_.hashDiffered(client_, shortHash(server_.hash()));
  }

  void expectPosition(const Desync& desync) {
    const auto difference = firstDifference(desync.client, *desync.server);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->owner, "entity 0");
    EXPECT_EQ(difference->field, "position");
  }

  std::vector<Input> inputs_{kStands, kRuns};
  Game server_{endlessLevel()};
  Game client_ = server_;
  DesyncDetector detector_{5, client_};
};

TEST_F(DesyncDetectorTest, ReportsNothingWithoutADesync) {
  EXPECT_FALSE(detector_.ended().has_value());
  EXPECT_FALSE(detector_.resynced(server_, inputs_).has_value());
}

TEST_F(DesyncDetectorTest, AMatchingHashDiscardsAPendingDesync) {
  desync();
  detector_.hashMatched(client_);
  EXPECT_FALSE(detector_.ended().has_value());
  detector_.hashDiffered(client_, shortHash(server_.hash()));
  EXPECT_TRUE(detector_.ended().has_value());
}

TEST_F(DesyncDetectorTest, ComparesAtTheServersTick) {
  desync();
  play(20);
  const Game client = client_;
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->round, 5u);
  EXPECT_EQ(found->matchedAt, kMatchingTicks);
  EXPECT_EQ(found->tick, kMatchingTicks + 3);
  EXPECT_NE(found->clientHash, found->serverHash);
  EXPECT_EQ(found->client, client);
  EXPECT_EQ(found->server, server_);
  expectPosition(*found);
}

TEST_F(DesyncDetectorTest, StartsOverAfterAResync) {
  desync();
  play(20);
  ASSERT_TRUE(detector_.resynced(server_, inputs_).has_value());
  EXPECT_FALSE(detector_.ended().has_value());
  client_ = server_;
  play(50);
  detector_.hashDiffered(client_, shortHash(client_.hash()) + 1);
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->matchedAt, kMatchingTicks + 23);
  const sim::Verification played = sim::Verifier(found->recording).run();
  EXPECT_EQ(played.fault, "");
  EXPECT_FALSE(played.divergence.has_value());
  EXPECT_EQ(played.firstTick, kMatchingTicks + 23);
  EXPECT_EQ(played.ticks, 50u);
}

TEST_F(DesyncDetectorTest, ComparesAnEarlierStateWhenTheClientIsAhead) {
  desync();
  play(20);
  const Game client = client_;
  playClient(7);
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->client, client);
  expectPosition(*found);
}

// The state contains the inputs of its last tick.
TEST_F(DesyncDetectorTest, AdvancesByTheLastTickOfTheState) {
  desync();
  play(20);
  inputs_[0] = kRuns;
  playServer(1);
  Game client = client_;
  client.advance(inputs_);
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->client, client);
}

// The inputs of the ticks between are unknown.
TEST_F(DesyncDetectorTest, KeepsTheLastClientStateWhenMoreTicksAreMissing) {
  desync();
  playServer(2);
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->client, client_);
  EXPECT_EQ(found->server, server_);
}

TEST_F(DesyncDetectorTest, KeepsOnlyTheLastStates) {
  desync();
  playServer(5);
  playClient(5 + static_cast<std::uint32_t>(DesyncDetector::kMaxStates));
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->client, client_);
}

TEST_F(DesyncDetectorTest, ReportsADesyncAtTheEndOfTheRound) {
  desync();
  play(5);
  const auto found = detector_.ended();
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->server.has_value());
  EXPECT_EQ(found->client, client_);
}

// Simulates a memory fault: replaying the recording shows where the game departs from its inputs.
TEST_F(DesyncDetectorTest, TheRecordingShowsADesyncThatInputsDoNotExplain) {
  desync();
  play(RecentRecording::kTicksBetweenCheckpoints);
  const auto found = detector_.resynced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  const sim::Verification played = sim::Verifier(found->recording).run();
  EXPECT_EQ(played.fault, "");
  ASSERT_TRUE(played.divergence.has_value());
  EXPECT_EQ(played.divergence->tick, kMatchingTicks + 1);
  ASSERT_TRUE(played.divergence->difference.has_value());
  EXPECT_EQ(played.divergence->difference->owner, "entity 0");
}

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
}  // namespace platon::desync_detector_test
