#include "server/match/played_round.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "server/match/match.h"
#include "tests/net/support/fake_client.h"
#include "tests/net/support/fake_client_network.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/test_levels.h"

namespace platon::played_round_test {
namespace {

Match recordedMatch(const std::vector<std::string>& texts, std::uint32_t maxPlayers = 8) {
  std::vector<LevelPointer> levels;
  for (const std::string& text : texts) levels.push_back(levelOf(text));
  return Match(LevelRotation(levels), {maxPlayers, "Test", true});
}

FakeClient player(std::uint32_t lead = 8) {
  return FakeClient("P", lead, [lead](std::uint32_t tick) { return static_cast<int>(tick / lead % 8); });
}

struct Recording {
  std::vector<std::uint8_t> bytes;
  std::uint32_t ticks = 0;
  bool finished = false;
};

/// The recordings of a match by round.
class Recordings {
 public:
  void take(Match& match) {
    for (const RecordingPiece& piece : match.takeRecording()) {
      Recording& whole = byRound_[piece.round];
      EXPECT_FALSE(whole.finished) << "round " << piece.round;
      EXPECT_FALSE(piece.bytes.empty());
      whole.bytes.insert(whole.bytes.end(), piece.bytes.begin(), piece.bytes.end());
      whole.ticks = piece.ticks;
      whole.finished = piece.last;
    }
  }

  std::size_t size() const { return byRound_.size(); }
  const Recording& of(std::uint32_t round) const { return byRound_.at(round); }

 private:
  std::map<std::uint32_t, Recording> byRound_;
};

sim::Verification verified(const Recording& recording, const sim::Verifier::Played& played = {}) {
  const sim::Verification found = sim::Verifier(recording.bytes).run(played);
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_EQ(found.fault, "");
  EXPECT_TRUE(recording.finished);
  EXPECT_EQ(found.ticks, recording.ticks);
  return found;
}

TEST(MatchRecorder, RecordsOnlyWhenRequested) {
  FakeClientNetwork network(Match(LevelRotation({levelOf(farGoalText())}), {8, "Test"}));
  network.add(player());
  network.run(200);
  network.match().stop("");
  EXPECT_TRUE(network.match().takeRecording().empty());
}

TEST(MatchRecorder, TheRecordingReplaysToTheSameHashes) {
  FakeClientNetwork network(recordedMatch({farGoalText()}),
                            {.lossPercent = 20, .delayMs = 3 * kTickMs, .jitterMs = 4 * kTickMs, .reorderPercent = 30},
                            9);
  network.add(player(20));
  network.run(100);
  network.add(player(24));
  network.run(150);
  network.leave(1);
  network.run(90);
  Match& match = network.match();
  const std::uint64_t hash = match.game().hash();
  const std::uint32_t ticks = match.game().tick();
  match.stop("");
  Recordings recordings;
  recordings.take(match);
  ASSERT_EQ(recordings.size(), 1u);
  std::vector<std::uint32_t> present;  // number of players by tick
  const sim::Verification found = verified(recordings.of(1), [&](std::span<const Input> inputs, const Game& game) {
    EXPECT_EQ(game.hash(), network.hashOf(1, game.tick()));
    const auto isPresent = [](Input input) { return input.has(Input::kPresent); };
    present.push_back(static_cast<std::uint32_t>(std::count_if(inputs.begin(), inputs.end(), isPresent)));
  });
  EXPECT_EQ(found.firstTick, 0u);
  EXPECT_EQ(found.ticks, ticks);
  EXPECT_EQ(found.hash, hash);
  EXPECT_EQ(found.slots, 2u);
  ASSERT_EQ(present.size(), ticks);
  EXPECT_EQ(present[90], 1u);
  EXPECT_EQ(present[200], 2u);
  EXPECT_EQ(present.back(), 1u);
}

// An incomplete recording can be verified up to its last checkpoint.
TEST(MatchRecorder, PiecesCanBeVerifiedDuringTheRound) {
  FakeClientNetwork network(recordedMatch({farGoalText()}));
  network.add(player());
  for (std::uint32_t tick = 1; tick <= 5 * kCheckpointTicks + 7; ++tick) network.tick();
  Recordings recordings;
  recordings.take(network.match());
  const Recording& cut = recordings.of(1);
  EXPECT_FALSE(cut.finished);
  const sim::Verification found = sim::Verifier(cut.bytes).run();
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_NE(found.fault, "");
  EXPECT_GE(found.ticks + kCheckpointTicks, network.match().game().tick());
  EXPECT_EQ(found.hash, network.hashOf(1, found.ticks));
}

TEST(MatchRecorder, EachRoundHasARecording) {
  FakeClientNetwork network(recordedMatch({nearGoalText(), farGoalText()}));
  network.add(player());
  Recordings recordings;
  for (int tick = 0; tick < 700; ++tick) {
    network.tick();
    recordings.take(network.match());
  }
  ASSERT_EQ(network.match().round(), 2u);
  network.match().stop("");
  recordings.take(network.match());
  ASSERT_EQ(recordings.size(), 2u);
  EXPECT_GE(verified(recordings.of(1)).ticks, MatchRounds::kPauseTicks);
  EXPECT_EQ(sim::Verifier(recordings.of(1).bytes).game()->level().text, nearGoalText());
  EXPECT_EQ(sim::Verifier(recordings.of(2).bytes).game()->level().text, farGoalText());
  EXPECT_EQ(verified(recordings.of(2)).hash, network.match().game().hash());
}

TEST(MatchRecorder, ARecordingEndsWhenTheLastPlayerLeaves) {
  FakeClientNetwork network(recordedMatch({farGoalText()}));
  network.add(player());
  network.run(400);
  network.leave(1);
  Recordings recordings;
  recordings.take(network.match());
  EXPECT_EQ(verified(recordings.of(1)).hash, network.match().game().hash());
  network.run(100);  // without players
  network.add(player());
  network.run(400);
  network.match().stop("");
  recordings.take(network.match());
  ASSERT_EQ(recordings.size(), 2u);
  EXPECT_EQ(verified(recordings.of(2)).hash, network.match().game().hash());
}

// The beginning of the round is part of it.
TEST(MatchRecorder, ARecordingBeginsAfterFiveSecondsOfPlay) {
  FakeClientNetwork network(recordedMatch({farGoalText()}));
  network.add(player());
  network.tick();
  network.run(MatchRecorder::kMinTicks - network.match().game().tick() - 1);
  EXPECT_TRUE(network.match().takeRecording().empty());
  network.run(1);
  Recordings recordings;
  recordings.take(network.match());
  ASSERT_EQ(recordings.size(), 1u);
  const sim::Verification found = sim::Verifier(recordings.of(1).bytes).run();
  EXPECT_EQ(found.firstTick, 0u);
  EXPECT_EQ(found.ticks, MatchRecorder::kMinTicks);
  EXPECT_EQ(found.hash, network.match().game().hash());
}

TEST(MatchRecorder, PlayersThatJoinAndLeaveAtOnceAreNotRecorded) {
  FakeClientNetwork network(recordedMatch({farGoalText()}));
  for (ClientId client = 1; client <= 20; ++client) {
    network.add(player());
    network.run(MatchRecorder::kMinTicks - 20);
    network.leave(client);
    network.run(10);
  }
  EXPECT_EQ(network.match().round(), 20u);
  EXPECT_TRUE(network.match().takeRecording().empty());
}

TEST(MatchRecorder, RecordsTheLargestNumberOfPlayers) {
  Match match = recordedMatch({farGoalText()}, kMaxPlayers);
  const auto hash = shortHash(levelOf(farGoalText())->hash);
  for (ClientId client = 1; client <= kMaxPlayers; ++client) match.receive(client, Hello{});
  Recordings recordings;
  for (std::uint32_t tick = 0; tick < 6 * kCheckpointTicks + 10; ++tick) {
    for (ClientId client = 1; client <= kMaxPlayers; ++client) {
      const Input input = validInput(static_cast<std::uint8_t>((client + tick / 9) % 8 | Input::kPresent));
      match.receive(client, PlayerInputs{1, 0, 0, hash, tick, {input}});
    }
    match.tick();
    match.takeOutgoing();
  }
  match.stop("");
  recordings.take(match);
  const sim::Verification found = verified(recordings.of(1));
  EXPECT_EQ(found.slots, kMaxPlayers);
  EXPECT_EQ(found.hash, match.game().hash());
}

}  // namespace
}  // namespace platon::played_round_test
