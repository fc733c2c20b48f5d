#include "platon/game/recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "platon/game/recording_reader.h"
#include "tests/shared/game/recorded_game.h"

namespace platon::recorder_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using State = RecordingReader::State;

TEST(RecorderTest, ARecordingContainsTheGameAsPlayed) {
  for (const std::uint32_t checkpointTicks : {1u, 7u, 60u, 3600u}) {
    const RecordedGame played = recordGame(200, checkpointTicks);
    RecordingReader reader(played.recording);
    ASSERT_TRUE(reader.level());
    EXPECT_EQ(reader.level()->hash, recordedLevel()->hash);
    std::uint32_t tick = 0;
    while (const auto block = reader.next()) {
      ASSERT_EQ(block->firstTick, tick);
      ASSERT_EQ(block->state, played.states[tick]) << "before tick " << tick;
      ASSERT_LE(block->ticks(), checkpointTicks);
      for (std::uint32_t i = 0; i < block->ticks(); ++i, ++tick) {
        ASSERT_TRUE(std::ranges::equal(block->inputsOf(i), played.inputs[tick])) << "tick " << tick;
        ASSERT_EQ(block->hashes[i], played.hashes[tick]) << "tick " << tick;
      }
    }
    EXPECT_EQ(tick, 200u);
    EXPECT_EQ(reader.state(), State::kComplete) << reader.fault();
  }
}

TEST(RecorderTest, ARecordingMayBeginInTheMiddleOfARound) {
  PlayedGame played(recordedLevel());
  played.run(100, Input::kRight);
  Recorder recorder(played.game);
  recorder.finish(played.game);
  const Bytes bytes = recorder.takeBytes();
  RecordingReader reader(bytes);
  const auto end = reader.next();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->firstTick, 100u);
  EXPECT_EQ(end->state, played.game.save());
  EXPECT_EQ(reader.state(), State::kComplete);
}

// The number of slots of a block is the largest number in any of its ticks.
TEST(RecorderTest, ABlockHasTheSlotsOfPlayersWhoJoinInIt) {
  Game game(recordedLevel());
  Recorder recorder(game);
  const std::vector<Input> one(1, Input{Input::kPresent});
  const std::vector<Input> three(3, Input{Input::kPresent | Input::kLeft});
  for (const auto& inputs : {one, three, one}) {
    game.advance(inputs);
    recorder.record(inputs, game);
  }
  recorder.finish(game);
  const Bytes bytes = recorder.takeBytes();
  const auto block = RecordingReader(bytes).next();
  ASSERT_TRUE(block);
  ASSERT_EQ(block->slots, 3u);
  EXPECT_TRUE(std::ranges::equal(block->inputsOf(0), std::vector<Input>{one[0], {}, {}}));
  EXPECT_TRUE(std::ranges::equal(block->inputsOf(1), three));
  EXPECT_TRUE(std::ranges::equal(block->inputsOf(2), std::vector<Input>{one[0], {}, {}}));
}

TEST(RecorderTest, AHeldButtonTakesOneRunPerBlock) {
  PlayedGame played(recordedLevel());
  Recorder recorder(played.game);
  played.hold(0, Input::kRight);
  for (int tick = 0; tick < 3600; ++tick) {
    played.advance();
    recorder.record(std::vector<Input>{Input{Input::kRight | Input::kPresent}}, played.game);
  }
  const std::size_t blocks = 60;
  const std::size_t head = kRecordingMagic.size() + 20 + recordedLevel()->text.size();
  const std::size_t hashes = 3600 * sizeof(std::uint64_t);
  EXPECT_LT(recorder.takeBytes().size(), head + hashes + blocks * 200);
}

TEST(RecorderTest, TakenBytesAreNotReturnedAgain) {
  Game game(recordedLevel());
  Recorder recorder(game, 2);
  EXPECT_FALSE(recorder.takeBytes().empty()) << "the head";
  game.advance({});
  recorder.record({}, game);
  EXPECT_TRUE(recorder.takeBytes().empty()) << "the block is not full yet";
  game.advance({});
  recorder.record({}, game);
  EXPECT_FALSE(recorder.takeBytes().empty());
  EXPECT_TRUE(recorder.takeBytes().empty());
}

}  // namespace
}  // namespace platon::recorder_test
