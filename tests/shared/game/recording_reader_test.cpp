#include "platon/game/recording_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "shared/exact/hash.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/recorded_game.h"

namespace platon::recording_reader_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using State = RecordingReader::State;

// Result of reading a recording to its end.
struct Reading {
  std::uint32_t ticks = 0;  // in all blocks read
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

TEST(RecordingReaderTest, ReadsTheCompleteBlocksOfATruncatedRecording) {
  const Bytes bytes = recordGame(50, 10).recording;
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

TEST(RecordingReaderTest, FindsEveryFlippedBit) {
  Bytes bytes = recordGame(20, 10, 2).recording;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    const Reading reading = read(bytes);
    ASSERT_EQ(reading.state, State::kDamaged) << "bit " << bit << ": " << reading.fault;
    ASSERT_TRUE(reading.fault.starts_with("byte ")) << reading.fault;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
  }
  EXPECT_EQ(read(bytes).state, State::kComplete);
}

TEST(RecordingReaderTest, ReadsTheBlocksBeforeADamagedOneAndNamesItsOffset) {
  Bytes bytes = recordGame(20, 10, 2).recording;
  RecordingReader reader(bytes);
  reader.next();
  const auto second = reader.next();
  ASSERT_TRUE(second);
  bytes[second->offset + 20] ^= 1;
  EXPECT_EQ(read(bytes).fault, "byte " + std::to_string(second->offset) + ": the checksum of the block is wrong");
  EXPECT_EQ(read(bytes).ticks, 10u);
}

TEST(RecordingReaderTest, RefusesInvalidRuns) {
  const Bytes hash(8, 0);
  const auto faultOf = [&](std::uint16_t ticks, std::uint16_t slots, Bytes runsAndHashes) {
    runsAndHashes.insert(runsAndHashes.end(), hash.begin(), hash.end());
    ForgedRecording forged{Game(recordedLevel())};
    forged.addBlock(0, ticks, slots, runsAndHashes);
    const std::string fault = read(forged.bytes()).fault;
    return fault.substr(std::min(fault.size(), fault.find(": ") + 2));
  };
  const std::string inputs = "the block has invalid inputs";
  const std::string size = "the block has too many ticks or slots";
  const std::string length = "the length of the block does not match its content";
  EXPECT_EQ(faultOf(1, 1, {0, 0, 128}), inputs) << "a run of 0 ticks";
  EXPECT_EQ(faultOf(1, 1, {2, 0, 128}), inputs) << "a run longer than the block";
  EXPECT_EQ(faultOf(1, 1, {1, 0, 64}), inputs) << "an unknown button";
  EXPECT_EQ(faultOf(1, 1, {1, 0, 1}), inputs) << "a button without a player";
  EXPECT_EQ(faultOf(1, 257, {}), size);
  EXPECT_EQ(faultOf(3601, 1, {}), size);
  EXPECT_EQ(faultOf(1, 1, {1, 0, 128, 0}), length);
  EXPECT_EQ(faultOf(2, 0, {}), length);
}

TEST(RecordingReaderTest, RefusesBlocksOutOfOrder) {
  ForgedRecording forged{Game(recordedLevel())};
  const Bytes oneTick{1, 0, 128, 0, 0, 0, 0, 0, 0, 0, 0};
  forged.addBlock(0, 1, 1, oneTick);
  const std::size_t end = forged.bytes().size();
  forged.addBlock(2, 1, 1, oneTick);
  EXPECT_EQ(read(forged.bytes()).fault,
            "byte " + std::to_string(end) + ": the block begins at tick 2 instead of tick 1");
}

// A first block that ended at tick 2^32 was skipped, whatever it held.
TEST(RecordingReaderTest, RefusesABlockWhoseTicksWrap) {
  const Bytes oneTick{1, 0, 128, 0, 0, 0, 0, 0, 0, 0, 0};
  ForgedRecording forged{Game(recordedLevel())};
  const std::size_t begin = forged.bytes().size();
  forged.addBlock(UINT32_MAX, 1, 1, oneTick);
  EXPECT_EQ(read(forged.bytes()).fault, "byte " + std::to_string(begin) + ": the block goes on beyond tick 4294967295");
  EXPECT_EQ(read(forged.bytes()).ticks, 0u);
}

TEST(RecordingReaderTest, RefusesBytesAfterTheEnd) {
  Bytes bytes = recordGame(5, 10).recording;
  bytes.push_back(0);
  EXPECT_EQ(read(bytes).fault,
            "byte " + std::to_string(bytes.size() - 1) + ": unexpected bytes after the end of the recording");
  EXPECT_EQ(read(bytes).state, State::kDamaged);
}

TEST(RecordingReaderTest, ReportsWhereATruncatedRecordingEnds) {
  const Bytes bytes = recordGame(20, 10).recording;
  RecordingReader reader(bytes);
  const auto first = reader.next();
  const auto second = reader.next();
  const auto end = reader.next();
  ASSERT_TRUE(first && second && end);
  const auto faultAt = [&](std::size_t length) { return read(std::span(bytes).first(length)).fault; };
  const auto text = [](std::size_t number) { return std::to_string(number); };
  EXPECT_EQ(faultAt(end->offset),
            "byte " + text(end->offset) + ": the recording is truncated before the block that marks its end");
  EXPECT_EQ(faultAt(end->offset - 1), "byte " + text(end->offset - 1) +
                                          ": the recording is truncated within the block at byte " +
                                          text(second->offset));
  EXPECT_EQ(faultAt(5), "byte 5: the recording is truncated within the header");
}

TEST(RecordingReaderTest, ReturnsNothingAfterTheEnd) {
  const Bytes bytes = recordGame(5, 10).recording;
  RecordingReader reader(bytes);
  while (const auto block = reader.next()) EXPECT_LE(block->ticks(), 5u);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.state(), State::kComplete);
  EXPECT_EQ(reader.fault(), "");
}

// A head with a correct checksum.
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

TEST(RecordingReaderTest, RefusesHeadsThatThisProgramCannotPlay) {
  EXPECT_EQ(read(headOf(kRulesVersion, recordedLevel()->text)).state, State::kTruncated);
  EXPECT_EQ(read(headOf(kRulesVersion + 1, recordedLevel()->text)).fault,
            "byte 8: recorded with version " + std::to_string(kRulesVersion + 1) +
                " of the rules, but this program has version " + std::to_string(kRulesVersion));
  EXPECT_TRUE(read(headOf(kRulesVersion, "CUBE\n")).fault.starts_with("byte 20: the level is invalid: level:1:1: "));
  const std::string tooLong(kMaxLevelBytes + 1, '\n');
  EXPECT_EQ(read(headOf(kRulesVersion, tooLong)).fault, "byte 0: the level text is longer than 4194304 bytes");
  const std::string level = "HEXAHEDRON\n0 -100 -150 0\n";
  EXPECT_EQ(read(std::span(reinterpret_cast<const std::uint8_t*>(level.data()), level.size())).fault,
            "byte 0: not a recording, or an unsupported version");
}

TEST(RecordingReaderTest, NamesTheFormatOfARecordingThatItDoesNotRead) {
  Bytes bytes = headOf(kRulesVersion, recordedLevel()->text);
  const char own = kRecordingMagic.back();
  for (const char format : {'0', '2', '9'}) {
    bytes[kRecordingMagic.size() - 1] = static_cast<std::uint8_t>(format);
    EXPECT_EQ(read(bytes).fault,
              std::string("byte 0: a recording of format ") + format + ", but this program reads format " + own);
  }
  for (const char other : {'/', ':'}) {
    bytes[kRecordingMagic.size() - 1] = static_cast<std::uint8_t>(other);
    EXPECT_EQ(read(bytes).fault, "byte 0: not a recording, or an unsupported version");
  }
}

TEST(RecordingReaderTest, AnIntactHeadTellsItsRulesAlsoWhenTheyAreOthers) {
  for (const std::uint32_t rules : {kRulesVersion, kRulesVersion + 1}) {
    std::vector<std::uint8_t> head = headOf(rules, "CUBE\n");
    const RecordingReader reader(head);
    EXPECT_EQ(reader.rules(), rules);
    EXPECT_EQ(std::string(reader.levelText().begin(), reader.levelText().end()), "CUBE\n");
    head[20] ^= 1;
    EXPECT_EQ(RecordingReader(head).rules(), std::nullopt);
    EXPECT_TRUE(RecordingReader(head).levelText().empty());
  }
}

}  // namespace
}  // namespace platon::recording_reader_test
