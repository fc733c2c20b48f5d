#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "platon/game/recorder.h"
#include "platon/game/recording_reader.h"
#include "shared/exact/hash.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/churn.h"

namespace platon {
namespace {

using Bytes = std::vector<std::uint8_t>;
using State = RecordingReader::State;

constexpr std::uint64_t kSeed = 29;

std::shared_ptr<const Level> level() {
  static const auto loaded = cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n60 -90 150 -90"});
  return loaded;
}

// What was played, beside its recording.
struct Played {
  Bytes recording;
  std::vector<std::vector<Input>> inputs;
  std::vector<std::uint64_t> hashes;
  std::vector<Bytes> states;  // before each tick, and the last
};

Played play(std::uint32_t ticks, std::uint32_t checkpointTicks, std::uint32_t slots = 3) {
  Game game(level());
  Recorder recorder(game, checkpointTicks);
  sim::Churn churn(kSeed, slots);
  Played played;
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    played.states.push_back(game.save());
    played.inputs.push_back(churn.next());
    game.advance(played.inputs.back());
    played.hashes.push_back(game.hash());
    recorder.record(played.inputs.back(), game);
    const Bytes more = recorder.takeBytes();
    played.recording.insert(played.recording.end(), more.begin(), more.end());
  }
  played.states.push_back(game.save());
  recorder.finish(game);
  const Bytes more = recorder.takeBytes();
  played.recording.insert(played.recording.end(), more.begin(), more.end());
  return played;
}

// Reads to the end; the ticks read and how it ended.
struct Reading {
  std::uint32_t ticks = 0;
  State state = State::kReading;
  std::string fault;
};

Reading read(std::span<const std::uint8_t> bytes) {
  RecordingReader reader(bytes);
  Reading reading;
  while (const auto block = reader.next()) reading.ticks += block->ticks();
  reading.state = reader.state();
  reading.fault = reader.fault();
  return reading;
}

TEST(RecordingTest, HoldsWhatWasPlayed) {
  for (const std::uint32_t checkpointTicks : {1u, 7u, 60u, 3600u}) {
    const Played played = play(200, checkpointTicks);
    RecordingReader reader(played.recording);
    ASSERT_TRUE(reader.level());
    EXPECT_EQ(reader.level()->hash, level()->hash);
    std::uint32_t tick = 0;
    while (const auto block = reader.next()) {
      ASSERT_EQ(block->first, tick);
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

TEST(RecordingTest, MayBeginInTheMiddleOfARound) {
  PlayedGame played(level());
  played.run(100, Input::kRight);
  Recorder recorder(played.game);
  recorder.finish(played.game);
  const Bytes bytes = recorder.takeBytes();
  RecordingReader reader(bytes);
  const auto end = reader.next();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->first, 100u);
  EXPECT_EQ(end->state, played.game.save());
  EXPECT_EQ(reader.state(), State::kComplete);
}

// The slots of a block are those of the tick that has most.
TEST(RecordingTest, SlotsMayBecomeMoreInsideABlock) {
  Game game(level());
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

TEST(RecordingTest, HeldButtonsCostNextToNothing) {
  PlayedGame played(level());
  Recorder recorder(played.game);
  played.hold(0, Input::kRight);
  for (int tick = 0; tick < 3600; ++tick) {
    played.advance();
    recorder.record(std::vector<Input>{Input{Input::kRight | Input::kPresent}}, played.game);
  }
  const std::size_t blocks = 60;
  const std::size_t head = kRecordingMagic.size() + 20 + level()->text.size();
  const std::size_t hashes = 3600 * sizeof(std::uint64_t);
  EXPECT_LT(recorder.takeBytes().size(), head + hashes + blocks * 200);
}

TEST(RecordingTest, WhereverItIsCutItsWholeBlocksAreRead) {
  const Bytes bytes = play(50, 10).recording;
  std::uint32_t ticks = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Reading reading = read(std::span(bytes).first(length));
    ASSERT_EQ(reading.state, State::kTruncated) << length << " bytes: " << reading.fault;
    ASSERT_TRUE(reading.fault.starts_with("byte " + std::to_string(length) + ": ")) << reading.fault;
    ASSERT_GE(reading.ticks, ticks);
    ticks = reading.ticks;
  }
  EXPECT_EQ(ticks, 50u);
}

TEST(RecordingTest, AnyFlippedBitIsFound) {
  Bytes bytes = play(20, 10, 2).recording;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    const Reading reading = read(bytes);
    ASSERT_EQ(reading.state, State::kDamaged) << "bit " << bit << ": " << reading.fault;
    ASSERT_TRUE(reading.fault.starts_with("byte ")) << reading.fault;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
  }
  EXPECT_EQ(read(bytes).state, State::kComplete);
}

// The block that is damaged, by its first byte; what comes before it has been read.
TEST(RecordingTest, NamesTheDamagedBlock) {
  Bytes bytes = play(20, 10, 2).recording;
  RecordingReader reader(bytes);
  reader.next();
  const auto second = reader.next();
  ASSERT_TRUE(second);
  bytes[second->offset + 20] ^= 1;
  EXPECT_EQ(read(bytes).fault, "byte " + std::to_string(second->offset) + ": the check sum of the block is wrong");
  EXPECT_EQ(read(bytes).ticks, 10u);
}

TEST(RecordingTest, RefusesRunsThatAreNone) {
  const Bytes hash(8, 0);
  const auto faultOf = [&](std::uint16_t ticks, std::uint16_t slots, Bytes rest) {
    rest.insert(rest.end(), hash.begin(), hash.end());
    ForgedRecording forged{Game(level())};
    forged.addBlock(0, ticks, slots, rest);
    const std::string fault = read(forged.bytes()).fault;
    return fault.substr(std::min(fault.size(), fault.find(": ") + 2));
  };
  const std::string none = "the inputs of the block are none";
  EXPECT_EQ(faultOf(1, 1, {0, 0, 128}), none) << "a run of no tick";
  EXPECT_EQ(faultOf(1, 1, {2, 0, 128}), none) << "a run beyond the block";
  EXPECT_EQ(faultOf(1, 1, {1, 0, 64}), none) << "no such button";
  EXPECT_EQ(faultOf(1, 1, {1, 0, 1}), none) << "a button of nobody";
  EXPECT_EQ(faultOf(1, 257, {}), "the block is larger than any may be");
  EXPECT_EQ(faultOf(3601, 1, {}), "the block is larger than any may be");
  EXPECT_EQ(faultOf(1, 1, {1, 0, 128, 0}), "the block is longer or shorter than what is in it");
  EXPECT_EQ(faultOf(2, 0, {}), "the block is longer or shorter than what is in it");
}

TEST(RecordingTest, RefusesBlocksOutOfOrder) {
  ForgedRecording forged{Game(level())};
  const Bytes oneTick{1, 0, 128, 0, 0, 0, 0, 0, 0, 0, 0};
  forged.addBlock(0, 1, 1, oneTick);
  const std::size_t end = forged.bytes().size();
  forged.addBlock(2, 1, 1, oneTick);
  EXPECT_EQ(read(forged.bytes()).fault,
            "byte " + std::to_string(end) + ": the block does not follow on the one before");
}

TEST(RecordingTest, NothingMayFollowTheEnd) {
  Bytes bytes = play(5, 10).recording;
  bytes.push_back(0);
  EXPECT_EQ(read(bytes).fault, "byte " + std::to_string(bytes.size() - 1) + ": something follows the end");
  EXPECT_EQ(read(bytes).state, State::kDamaged);
}

// A head with a right check sum.
Bytes headOf(std::uint32_t rules, const std::string& text) {
  StateWriter head;
  head.append(kRecordingMagic);
  head.add(rules);
  head.add(static_cast<std::uint32_t>(text.size()));
  head.add(~static_cast<std::uint32_t>(text.size()));
  head.append(text);
  head.add(hashOf(head.bytes()));
  return head.take();
}

TEST(RecordingTest, RefusesHeadsThatItCannotPlay) {
  EXPECT_EQ(read(headOf(kRulesVersion, level()->text)).state, State::kTruncated);
  EXPECT_EQ(read(headOf(kRulesVersion + 1, level()->text)).fault,
            "byte 8: it was played by version " + std::to_string(kRulesVersion + 1) +
                " of the rules, this program plays by version " + std::to_string(kRulesVersion));
  EXPECT_TRUE(read(headOf(kRulesVersion, "CUBE\n")).fault.starts_with("byte 20: the level has an error: level:1:1: "));
  const std::string tooLong(kMaxLevelBytes + 1, '\n');
  EXPECT_EQ(read(headOf(kRulesVersion, tooLong)).fault, "byte 0: the level text is too long for a level");
  const std::string level = "HEXAHEDRON\n0 -100 -150 0\n";
  EXPECT_EQ(read(std::span(reinterpret_cast<const std::uint8_t*>(level.data()), level.size())).fault,
            "byte 0: this is no recording, or one of another format");
}

}  // namespace
}  // namespace platon
