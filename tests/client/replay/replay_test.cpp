#include "client/replay/replay.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "client/replay/run_cutter.h"
#include "client/replay/run_list.h"
#include "client/replay/run_track.h"
#include "tests/client/replay/older_rules.h"
#include "tests/client/replay/replay_of.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/crowded_levels.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::replay_test {
namespace {

TEST(RecordingHead, IsReadFromTheFirstBytes) {
  const std::vector<std::uint8_t> recording = recordGame(100, 60).recording;
  const std::size_t bytes = Recorder(Game(recordedLevel())).takeBytes().size();
  const auto head = readRecordingHead(std::span(recording).first(bytes));
  ASSERT_TRUE(head && head->level);
  EXPECT_EQ(head->rules, kRulesVersion);
  EXPECT_EQ(head->level->hash, recordedLevel()->hash);
  EXPECT_FALSE(readRecordingHead(std::span(recording).first(bytes - 1)));
  EXPECT_FALSE(readRecordingHead({}));
}

TEST(RecordingHead, OfOlderRulesIsReadToo) {
  const auto older = asOfOlderRules(recordGame(10, 60).recording, *recordedLevel());
  const auto head = readRecordingHead(older);
  ASSERT_TRUE(head && head->level);
  EXPECT_EQ(head->rules, kRulesVersion - 1);
  EXPECT_EQ(head->level->hash, recordedLevel()->hash);
}

TEST(RecordingHead, ADamagedOneIsNoneWhateverItsRules) {
  const std::vector<std::uint8_t> recording = recordGame(10, 60).recording;
  const auto older = asOfOlderRules(recording, *recordedLevel());
  for (std::vector<std::uint8_t> bytes : {recording, older}) {
    for (const std::size_t place : {0U, 8U, 12U, 16U, 40U}) {
      bytes[place] ^= 4;
      EXPECT_FALSE(readRecordingHead(bytes)) << place;
      bytes[place] ^= 4;
    }
  }
}

TEST(RecordingHead, TheTextNamesBothVersions) {
  const std::string text = otherRulesText(3);
  EXPECT_NE(text.find("version 3 of the rules"), std::string::npos);
  EXPECT_NE(text.find("version " + std::to_string(kRulesVersion)), std::string::npos);
  EXPECT_NE(text.find("cannot play it"), std::string::npos);
}

std::string faultAtTheEndOf(const std::vector<std::uint8_t>& recording) {
  RecordingReader reader(recording);
  while (reader.next()) {
  }
  return recordingFault(reader, recording);
}

TEST(RecordingFault, TellsWhatIsCutOffFromWhatIsDamaged) {
  const std::vector<std::uint8_t> whole = recordGame(100, 60).recording;
  EXPECT_EQ(faultAtTheEndOf(whole), "");
  EXPECT_EQ(faultAtTheEndOf({whole.begin(), whole.end() - 1}).find("is a recording that is cut off: byte "), 0U);
  auto damaged = whole;
  damaged.back() ^= 1;
  EXPECT_EQ(faultAtTheEndOf(damaged).find(damagedText("byte ")), 0U);
  EXPECT_EQ(faultAtTheEndOf({1, 2, 3}), "cannot be played: byte 0: not a recording, or an unsupported version");
}

std::string faultOf(std::span<const std::uint8_t> recording) {
  const auto read = Replay::read(recording);
  return std::holds_alternative<std::string>(read) ? std::get<std::string>(read) : "none";
}

// The hash of the game after each tick, from the first to the last, of a straight play.
std::vector<std::uint64_t> straight(const Replay& replay) {
  Game game = replay.gameAfter(0);
  std::vector<std::uint64_t> hashes{game.hash()};
  for (std::uint32_t tick = 0; tick < replay.ticks(); ++tick) {
    game.advance(replay.inputsOf(tick));
    hashes.push_back(game.hash());
  }
  return hashes;
}

class GoldenReplay : public testing::TestWithParam<std::string> {};

TEST_P(GoldenReplay, EachTickIsThatOfTheStraightPlay) {
  const auto replay = replayOf(readBytes(GetParam()));
  const auto hashes = straight(*replay);
  for (std::uint32_t tick = 0; tick <= replay->ticks(); tick += 37) {
    ASSERT_EQ(replay->gameAfter(tick).hash(), hashes[tick]) << tick;
  }
  ASSERT_EQ(replay->gameAfter(replay->ticks()).hash(), hashes.back());
}

INSTANTIATE_TEST_SUITE_P(All, GoldenReplay, testing::ValuesIn(filesIn("tests/determinism/golden", ".recording")),
                         [](const auto& file) { return std::filesystem::path(file.param).stem().string(); });

TEST(Replay, ReachesAnyTickInAnyOrder) {
  const RecordedGame recorded = recordGame(700, 50);
  const auto replay = replayOf(recorded.recording);
  ASSERT_EQ(replay->ticks(), 700U);
  properties::forEachCase(3, [&](oracle::RandomSource& random) {
    for (int i = 0; i < 100; ++i) {
      const auto tick = static_cast<std::uint32_t>(random.below(701));
      ASSERT_EQ(replay->gameAfter(tick).save(), recorded.states[tick]) << tick;
    }
  });
}

TEST(Replay, KeepsABoundedNumberOfStates) {
  const auto replay = replayOf(recordGame(20'000, 600, 1).recording);
  EXPECT_LE(replay->ticks() / replay->interval() + 1, Replay::kMaxStates);
  EXPECT_GE(replay->interval(), Replay::kMinInterval);
}

TEST(Replay, PlaysARecordingFromTheMiddleOfARound) {
  PlayedGame played(recordedLevel());
  played.run(90, Input::kRight);
  Recorder recorder(played.game);
  const std::vector<Input> inputs{{Input::kPresent | Input::kJump}};
  for (int i = 0; i < 70; ++i) {
    played.game.advance(inputs);
    recorder.record(inputs, played.game);
  }
  recorder.finish(played.game);
  const auto replay = replayOf(recorder.takeBytes());
  EXPECT_EQ(replay->gameAfter(0).tick(), 90U);
  EXPECT_TRUE(replay->gameAfter(70) == played.game);
}

TEST(Replay, OlderRulesAreRefusedWithTheirVersion) {
  EXPECT_EQ(faultOf(asOfOlderRules(recordGame(10, 60).recording, *recordedLevel())),
            "was recorded with version " + std::to_string(kRulesVersion - 1) +
                " of the rules; this program has version " + std::to_string(kRulesVersion) + " and cannot play it");
}

TEST(Replay, EveryDamageIsRefused) {
  const std::vector<std::uint8_t> recording = recordGame(130, 60).recording;
  for (std::size_t place = 0; place < recording.size(); place += 7) {
    std::vector<std::uint8_t> bytes = recording;
    bytes[place] ^= 1;
    ASSERT_NE(faultOf(bytes), "none") << place;
  }
}

TEST(Replay, AnyEndBeforeTheLastByteIsRefused) {
  const std::vector<std::uint8_t> recording = recordGame(130, 60).recording;
  for (std::size_t bytes = 0; bytes < recording.size(); bytes += 11) {
    ASSERT_NE(faultOf(std::span(recording).first(bytes)), "none") << bytes;
  }
  EXPECT_EQ(faultOf(std::span(recording).first(recording.size() - 1)).substr(0, 32),
            "is a recording that is cut off: ");
}

TEST(Replay, WhatIsNoRecordingIsRefused) {
  const std::vector<std::uint8_t> bytes(100, 'x');
  EXPECT_EQ(faultOf(bytes), "cannot be played: byte 0: not a recording, or an unsupported version");
}

TEST(Replay, ARecordingOfAnotherGameIsRefused) {
  Game game(recordedLevel());
  ForgedRecording forged(game);
  forged.addBlock(0, 1, 0, std::vector<std::uint8_t>(8, 1));
  Game after = game;
  after.advance({});
  forged.setState(after.save());
  forged.addBlock(1, 0, 0, {});
  EXPECT_EQ(faultOf(forged.bytes()),
            "is a damaged recording: playing it does not lead to the recorded state at tick 1");
  ForgedRecording late(game);
  late.addBlock(5, 0, 0, {});
  EXPECT_EQ(faultOf(late.bytes()), "is a damaged recording: its first state is not valid on its level");
  ForgedRecording none(game);
  none.setState({1, 2, 3});
  none.addBlock(0, 0, 0, {});
  EXPECT_EQ(faultOf(none.bytes()), "is a damaged recording: its first state is not valid on its level");
}

// A block of so many ticks in which nobody is present.
std::vector<std::uint8_t> emptyTicks(std::uint16_t ticks, std::uint16_t slots) {
  StateWriter runs;
  for (std::uint16_t slot = 0; slot < slots; ++slot) {
    runs.add(ticks);
    runs.add(std::uint8_t{0});
  }
  for (std::uint16_t tick = 0; tick < ticks; ++tick) runs.add(std::uint64_t{0});
  return runs.take();
}

// A small file can hold hours of play by hundreds. It is refused before anything is played.
TEST(Replay, WhatTakesTooLongIsRefusedBeforeItIsPlayed) {
  for (const std::uint16_t slots : {std::uint16_t{0}, std::uint16_t{256}}) {
    PlayedGame played(recordedLevel());
    if (slots == 0) played.hold(255, 0);  // the slots of the state count, too
    played.advance();
    ForgedRecording forged(played.game);
    const std::vector<std::uint8_t> block = emptyTicks(kMaxCheckpointTicks, slots);
    for (std::uint32_t i = 0; i < 20; ++i) {
      forged.addBlock(played.game.tick() + i * kMaxCheckpointTicks, kMaxCheckpointTicks, slots, block);
    }
    EXPECT_LT(forged.bytes().size(), 2'000'000U);
    EXPECT_EQ(faultOf(forged.bytes()), Replay::kTooLong) << slots;
    const TemporaryFolder folder;
    writeText(folder / "file", {reinterpret_cast<const char*>(forged.bytes().data()), forged.bytes().size()});
    EXPECT_EQ(readRecordingFacts(folder / "file").note, Replay::kTooLong);
  }
}

// Ticks that may be played on the level by players in so many slots.
std::uint64_t ticksAllowed(const std::shared_ptr<const Level>& level, std::uint32_t slots) {
  PlayCost cost{Game(level)};
  std::uint64_t ticks = 0;
  while (cost.add(kTicksPerSecond, slots)) ticks += kTicksPerSecond;
  return ticks;
}

// What a server records: a round, and the pause behind it.
TEST(PlayCost, ALongRoundOf16PlayersIsAllowedOnTheMostCrowdedLevels) {
  for (const CrowdedLevel& crowded : crowdedLevels()) {
    const auto level = loadLevel(crowded.text(1)).level;
    ASSERT_EQ(segmentsInReach(*level), kMaxSegmentsInReach) << crowded.name;
    EXPECT_EQ(ticksAllowed(level, 16), 6U * 60 * kTicksPerSecond);
    EXPECT_GE(ticksAllowed(level, 1), RunCutter::kMaxTicks);
  }
}

TEST(PlayCost, ALongRoundOf256PlayersIsAllowedOnEveryShippedLevel) {
  for (const std::string& file : shippedLevels()) {
    EXPECT_GE(ticksAllowed(levelOf(readText(file)), kMaxPlayers), kRoundTicks + 30 * kTicksPerSecond) << file;
  }
}

TEST(Replay, TellsHowFarItIs) {
  ReplayProgress progress = 0;
  EXPECT_TRUE(
      std::holds_alternative<std::shared_ptr<const Replay>>(Replay::read(recordGame(50, 60).recording, {}, &progress)));
  EXPECT_EQ(progress, 98U) << "before the last of 50 ticks";
}

TEST(Replay, StopsWhenItIsAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  const auto read = Replay::read(recordGame(100, 60).recording, stop.get_token());
  EXPECT_EQ(std::get<std::string>(read), "was not read to its end");
}

TEST(ReplayFile, IsRead) {
  const auto replay = readReplay("tests/determinism/golden/hexahedron.recording");
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Replay>>(replay));
  EXPECT_GE(std::get<std::shared_ptr<const Replay>>(replay)->ticks(), 1800U);
}

TEST(ReplayFile, AFaultNamesTheFile) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "missing").string();
  const auto none = readReplay(missing);
  EXPECT_EQ(std::get<std::string>(none), missing + ": cannot be read: No such file or directory");
  const std::string text = (folder / "text").string();
  writeText(text, "no recording");
  const auto other = readReplay(text);
  EXPECT_EQ(std::get<std::string>(other),
            text + ": cannot be played: byte 0: not a recording, or an unsupported version");
}

TEST(ReplayFile, APipeIsNotWaitedFor) {
  const TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(std::get<std::string>(readReplay(pipe)), pipe + ": cannot be read: it is a pipe, not a regular file");
  EXPECT_FALSE(readRecordingHeadOf(pipe));
  EXPECT_EQ(readRecordingFacts(pipe).note, "cannot be read: it is a pipe, not a regular file");
  EXPECT_EQ(std::get<std::string>(readReplay(folder.path())),
            folder.path().string() + ": cannot be read: Is a directory");
}

TEST(ReplayFile, AStopEndsTheReading) {
  std::stop_source stop;
  stop.request_stop();
  const std::filesystem::path file = "levels/data/ways/01_run_and_jump.recording";
  const RecordingBytes read = readRecordingBytes(file, stop.get_token());
  EXPECT_EQ(read.content, "");
  EXPECT_EQ(read.fault, "was not read to its end");
  const std::string fault = file.string() + ": was not read to its end";
  EXPECT_EQ(std::get<std::string>(readReplay(file, stop.get_token())), fault);
  EXPECT_EQ(std::get<std::string>(readTrack(file, nullptr, stop.get_token())), fault);
  EXPECT_FALSE(readRecordingHeadOf(file, stop.get_token()));
}

TEST(ReplayFile, ALargeFileIsReadWhole) {
  const TemporaryFolder folder;
  std::string content(3 * (std::size_t{1} << 20), 'a');
  for (std::size_t i = 0; i < content.size(); i += 1000) content[i] = static_cast<char>('a' + i % 26);
  for (const std::size_t bytes : {content.size(), content.size() - 1, std::size_t{0}}) {
    writeText(folder / "file", content.substr(0, bytes));
    EXPECT_TRUE(readRecordingBytes(folder / "file").content == content.substr(0, bytes)) << bytes;
  }
  std::filesystem::resize_file(folder / "file", Replay::kMaxBytes);
  EXPECT_EQ(readRecordingBytes(folder / "file").content.size(), Replay::kMaxBytes);
  std::filesystem::resize_file(folder / "file", Replay::kMaxBytes + 1);
  EXPECT_EQ(readRecordingBytes(folder / "file").fault, "is larger than any recording that can be played");
}

}  // namespace
}  // namespace platon::replay_test
