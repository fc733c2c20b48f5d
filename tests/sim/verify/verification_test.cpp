#include "tests/sim/verify/verification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "platon/game/recorder.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/churn.h"

namespace platon::sim::verification_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kSeed = 50;

std::shared_ptr<const Level> level() {
  const std::string lines = "-240 -200 240 -200\n60 -90 150 -90\n-100 20 100 40";
  static const auto loaded = cubeLevel("0 0 -180 0", {lines, lines, lines, lines, lines, lines});
  return loaded;
}

// Records a game. `change` may change the game after each tick, before the tick is recorded.
Bytes record(std::uint32_t ticks, std::uint32_t checkpointTicks, const std::function<void(Game&)>& change = {}) {
  Game game(level());
  Recorder recorder(game, checkpointTicks);
  Churn churn(kSeed, 3);
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    const auto& inputs = churn.next();
    game.advance(inputs);
    if (change) change(game);
    recorder.record(inputs, game);
  }
  recorder.finish(game);
  return recorder.takeBytes();
}

TEST(VerificationTest, AnUnchangedRecordingDoesNotDiverge) {
  const Bytes bytes = record(500, 60);
  const Verification found = Verifier(bytes).run();
  EXPECT_EQ(found.firstTick, 0u);
  EXPECT_EQ(found.ticks, 500u);
  EXPECT_EQ(found.slots, 3u);
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence);
}

TEST(VerificationTest, AReplayFromACheckpointEndsInTheSameState) {
  const Bytes bytes = record(500, 60);
  const std::uint64_t hash = Verifier(bytes).run().hash;
  for (const std::uint32_t from : {1u, 59u, 60u, 61u, 479u, 480u, 499u}) {
    const Verification found = Verifier(bytes, from).run();
    EXPECT_EQ(found.firstTick, from / 60 * 60);
    EXPECT_EQ(found.ticks, 500 - found.firstTick);
    EXPECT_EQ(found.hash, hash);
    EXPECT_FALSE(found.divergence);
  }
  const Verification beyond = Verifier(bytes, 100000).run();
  EXPECT_EQ(beyond.firstTick, 500u);
  EXPECT_EQ(beyond.ticks, 0u);
  EXPECT_EQ(beyond.hash, hash);
}

// Changes one bit of the state after tick `at`. False when the changed state is invalid.
bool flipBit(Game& game, std::uint32_t at, std::size_t bit) {
  if (game.tick() != at) return true;
  Bytes bytes = game.save();
  bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
  return game.restore(bytes);
}

// With a checkpoint at every tick, the tick and the field of any changed bit are found.
TEST(VerificationTest, FindsTickAndFieldOfEveryChangedBit) {
  constexpr std::uint32_t kAt = 40;
  Game honest(level());
  Churn churn(kSeed, 3);
  while (honest.tick() < kAt) honest.advance(churn.next());
  int named = 0;
  for (std::size_t bit = 0; bit < 8 * honest.save().size(); ++bit) {
    Game changed = honest;
    if (!flipBit(changed, kAt, bit) || changed.tick() != kAt) continue;
    const auto expected = firstDifference(honest, changed);
    ASSERT_TRUE(expected) << "bit " << bit;
    const Bytes bytes = record(kAt + 1, 1, [&](Game& game) { flipBit(game, kAt, bit); });
    const Verification found = Verifier(bytes).run();
    ASSERT_TRUE(found.divergence) << "bit " << bit;
    EXPECT_EQ(found.divergence->tick, kAt);
    EXPECT_EQ(found.divergence->comparedAt, kAt);
    EXPECT_EQ(found.ticks, kAt);
    ASSERT_TRUE(found.divergence->difference) << "bit " << bit;
    EXPECT_EQ(found.divergence->difference->owner, expected->owner) << "bit " << bit;
    EXPECT_EQ(found.divergence->difference->field, expected->field) << "bit " << bit;
    EXPECT_EQ(found.divergence->difference->left, expected->left);
    EXPECT_EQ(found.divergence->difference->right, expected->right);
    ++named;
  }
  EXPECT_GT(named, 300);
}

TEST(VerificationTest, FindsTheTickAndComparesStatesAtTheNextCheckpoint) {
  const Bytes bytes = record(400, 60, [](Game& game) { flipBit(game, 130, 8 * 10); });
  const Verification found = Verifier(bytes).run();
  ASSERT_TRUE(found.divergence);
  EXPECT_EQ(found.divergence->tick, 130u);
  EXPECT_NE(found.divergence->replayed, found.divergence->recorded);
  EXPECT_EQ(found.divergence->comparedAt, 180u);
}

TEST(VerificationTest, ComparesStatesAtTheEndAfterTheLastCheckpoint) {
  const Bytes bytes = record(130, 60, [](Game& game) { flipBit(game, 125, 8 * 10); });
  const Verification found = Verifier(bytes).run();
  ASSERT_TRUE(found.divergence);
  EXPECT_EQ(found.divergence->tick, 125u);
  EXPECT_EQ(found.divergence->comparedAt, 130u);
}

TEST(VerificationTest, ReplaysATruncatedRecordingToItsEnd) {
  const Bytes bytes = record(300, 60);
  const Verification found = Verifier(std::span(bytes).first(bytes.size() - 1)).run();
  EXPECT_EQ(found.ticks, 300u);
  EXPECT_FALSE(found.divergence);
  EXPECT_TRUE(found.fault.starts_with("byte " + std::to_string(bytes.size() - 1) + ": the recording is truncated"));

  const Verification half = Verifier(std::span(bytes).first(bytes.size() / 2)).run();
  EXPECT_GE(half.ticks, 60u);
  EXPECT_LT(half.ticks, 300u);
  EXPECT_EQ(half.ticks % 60, 0u);
  EXPECT_FALSE(half.divergence);
}

TEST(VerificationTest, StartsAtTheLastCheckpointOfATruncatedRecording) {
  const Bytes bytes = record(300, 60);
  const Verification found = Verifier(std::span(bytes).first(bytes.size() - 1000), 100000).run();
  EXPECT_EQ(found.ticks, 60u);
  EXPECT_GT(found.firstTick, 0u);
  EXPECT_FALSE(found.fault.empty());
  EXPECT_FALSE(found.divergence);
}

TEST(VerificationTest, TellsWhichPartHasBeenReplayed) {
  const Bytes bytes = record(500, 60);
  for (const std::uint32_t from : {0u, 250u}) {
    Verifier verifier(bytes, from);
    std::vector<double> parts;
    verifier.run([&](std::span<const Input>, const Game&) { parts.push_back(verifier.part()); });
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_EQ(parts.front(), 0);
    EXPECT_GT(parts.back(), 0.5);
    EXPECT_LT(parts.back(), 1);
    EXPECT_EQ(verifier.part(), 1);
  }
}

TEST(VerificationTest, RefusesBytesThatAreNotARecording) {
  const Bytes bytes{1, 2, 3};
  Verifier verifier(bytes);
  EXPECT_EQ(verifier.game(), nullptr);
  EXPECT_EQ(verifier.run().fault, "byte 0: not a recording, or an unsupported version");
}

TEST(VerificationTest, RefusesAnInvalidState) {
  ForgedRecording forged{Game(level())};
  const std::size_t head = forged.bytes().size();
  forged.setState({1, 2, 3});
  forged.addBlock(0, 0, 0, {});
  Verifier verifier(forged.bytes());
  EXPECT_EQ(verifier.game(), nullptr);
  EXPECT_EQ(verifier.run().fault,
            "byte " + std::to_string(head) + ": the state of the block is not valid on this level");
}

// All blocks of a recording, each `later` ticks later, with the states and hashes as they are.
Bytes shifted(const Bytes& recording, std::uint32_t later) {
  RecordingReader reader(recording);
  ForgedRecording forged{Game(level())};
  while (const auto block = reader.next()) {
    StateWriter rest;
    for (std::uint32_t slot = 0; slot < block->slots; ++slot) {
      for (std::uint32_t tick = 0; tick < block->ticks(); ++tick) {
        rest.add(std::uint16_t{1});
        rest.add(block->inputsOf(tick)[slot].buttons);
      }
    }
    for (const std::uint64_t hash : block->hashes) rest.add(hash);
    forged.setState(block->state);
    forged.addBlock(block->firstTick + later, static_cast<std::uint16_t>(block->ticks()),
                    static_cast<std::uint16_t>(block->slots), rest.take());
  }
  return forged.bytes();
}

TEST(VerificationTest, TheTicksOfTheBlocksAreThoseOfTheirStates) {
  const Bytes bytes = record(130, 60);
  EXPECT_EQ(Verifier(shifted(bytes, 0)).run().fault, "");
  const Verification found = Verifier(shifted(bytes, 123456)).run();
  EXPECT_TRUE(found.fault.ends_with(": the block begins at tick 123456, but its state is that of tick 0"))
      << found.fault;
  EXPECT_EQ(found.ticks, 0u);
}

TEST(VerificationTest, ARecordingThatBeginsWithAPlayerBeginsInMidGame) {
  EXPECT_FALSE(Verifier(record(90, 60)).run().beginsInMidGame);
  EXPECT_TRUE(Verifier(record(90, 60), 60).run().beginsInMidGame);
  Game game(level());
  const Input present[] = {validInput(Input::kPresent)};
  game.advance(present);
  Recorder recorder(game);
  game.advance(present);
  recorder.record(present, game);
  recorder.finish(game);
  const Verification found = Verifier(recorder.takeBytes()).run();
  EXPECT_TRUE(found.beginsInMidGame);
  EXPECT_FALSE(found.divergence);
}

}  // namespace
}  // namespace platon::sim::verification_test
