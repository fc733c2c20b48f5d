#include "client/replay/run_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "client/replay/replay.h"
#include "client/replay/run_track.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/protocol/work/no_thread.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::run_list_test {
namespace {

class RecordingFactsTest : public testing::Test {
 protected:
  RecordingFactsTest() {
    followed_.hold(700, 0);  // more than one block
    followed_.holdToGoal(300, Input::kRight);
  }
  RecordingFacts factsOf(const std::vector<std::uint8_t>& recording) const {
    writeText(file_, {reinterpret_cast<const char*>(recording.data()), recording.size()});
    return readRecordingFacts(file_);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "file";
  FollowedGame followed_{
      levelOf("# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n")};
};

TEST_F(RecordingFactsTest, ARunHasItsTime) {
  const RecordingFacts facts = factsOf(followed_.run->recording);
  EXPECT_EQ(facts.note, "");
  EXPECT_EQ(facts.rules, kRulesVersion);
  ASSERT_TRUE(facts.level);
  EXPECT_EQ(facts.level->title, "Floor");
  EXPECT_EQ(facts.ticks, followed_.time);
}

TEST_F(RecordingFactsTest, TheTimesAreThoseOfTheWholePlay) {
  for (const auto& entry : std::filesystem::directory_iterator("levels/data/ways")) {
    if (entry.path().extension() != ".recording") continue;
    const RecordingFacts facts = readRecordingFacts(entry.path());
    const auto track = readTrack(entry.path());
    const auto* const run = std::get_if<RunTrack>(&track);
    EXPECT_EQ(facts.ticks, run == nullptr ? std::nullopt : std::optional(run->ticks)) << entry.path();
    EXPECT_EQ(facts.note, "") << entry.path();
  }
}

TEST_F(RecordingFactsTest, ARoundHasNoTime) {
  const RecordingFacts facts = factsOf(recordGame(100, 60).recording);
  EXPECT_EQ(facts.ticks, std::nullopt);
  EXPECT_EQ(facts.noRun, "is no run: it does not end with a player at the goal");
  EXPECT_EQ(facts.note, "");
}

TEST_F(RecordingFactsTest, SaysWhatCannotBePlayed) {
  EXPECT_EQ(factsOf({1, 2, 3}).note, "is not a recording");
  EXPECT_EQ(readRecordingFacts(folder_ / "missing").note, "cannot be read: No such file or directory");
  const auto older = asOfOlderRules(followed_.run->recording, followed_.game.level());
  const RecordingFacts facts = factsOf(older);
  EXPECT_EQ(facts.note, otherRulesText(kRulesVersion - 1));
  EXPECT_EQ(facts.rules, kRulesVersion - 1);
  ASSERT_TRUE(facts.level);
  EXPECT_EQ(facts.level->title, "Floor");
}

TEST_F(RecordingFactsTest, ACutOffOrDamagedRecordingSaysSo) {
  const auto& whole = followed_.run->recording;
  EXPECT_EQ(factsOf({whole.begin(), whole.begin() + 10}).note.find("is a recording that is cut off: "), 0U);
  EXPECT_EQ(factsOf({whole.begin(), whole.end() - 1}).note.find("is a recording that is cut off: "), 0U);
  auto damaged = whole;
  damaged.back() ^= 1;
  const RecordingFacts facts = factsOf(damaged);
  EXPECT_EQ(facts.note.find("is a damaged recording: "), 0U) << facts.note;
  EXPECT_EQ(facts.ticks, std::nullopt);
}

TEST_F(RecordingFactsTest, StopsWhenItIsAskedTo) {
  factsOf(followed_.run->recording);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(readRecordingFacts(file_, stop.get_token()).ticks, std::nullopt);
}

namespace fs = std::filesystem;

constexpr const char* kRecording = "levels/data/ways/01_run_and_jump.recording";

// As the list of a folder has it.
DatedFile dated(const fs::path& file) { return {file, fs::file_size(file), fs::last_write_time(file)}; }

class FactsReaderTest : public testing::Test {
 protected:
  FactsReaderTest() { writeText(file_, readText(kRecording)); }

  bool waitFor(const fs::path& file) {
    return waitUntil([&] {
      reader_.poll();
      return reader_.find(file) != nullptr;
    });
  }

  const TemporaryFolder folder_;
  const fs::path file_ = folder_ / "file";
  FactsReader reader_;
};

TEST_F(FactsReaderTest, ReadsEachFileOnce) {
  writeText(folder_ / "text", "no recording");
  reader_.read({dated(file_), dated(folder_ / "text")});
  ASSERT_TRUE(waitFor(folder_ / "text"));
  EXPECT_TRUE(reader_.find(file_)->ticks);
  EXPECT_EQ(reader_.find(folder_ / "text")->note, "is not a recording");
  reader_.read({dated(file_)});
  EXPECT_NE(reader_.find(file_), nullptr) << "remembered";
  EXPECT_EQ(reader_.find(folder_ / "text"), nullptr) << "forgotten";
  EXPECT_FALSE(reader_.poll());
}

TEST_F(FactsReaderTest, AChangedFileIsReadAgain) {
  reader_.read({dated(file_)});
  ASSERT_TRUE(waitFor(file_));
  fs::last_write_time(file_, fs::last_write_time(file_) - std::chrono::hours(1));
  reader_.read({dated(file_)});
  EXPECT_EQ(reader_.find(file_), nullptr);
  writeText(file_, "no recording");
  reader_.read({dated(file_)});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "is not a recording");
}

TEST_F(FactsReaderTest, AGrowingOrVanishedFileSaysSo) {
  DatedFile before = dated(file_);
  before.bytes -= 1;
  reader_.read({before});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "is still being written; open this page again later");
  const DatedFile gone = dated(file_);
  fs::remove(file_);
  reader_.read({gone});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "cannot be read: No such file or directory");
}

TEST_F(FactsReaderTest, WithoutAThreadOneFileIsReadAtATime) {
  FactsReader reader(noThread);
  std::vector<fs::path> files;
  for (const char* const name : {"a", "b", "c"}) {
    files.push_back(folder_ / name);
    writeText(files.back(), readText(kRecording));
  }
  reader.read({dated(files[0]), dated(files[1]), dated(files[2])});
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(reader.find(files[i]), nullptr);
    EXPECT_TRUE(reader.poll());
    ASSERT_NE(reader.find(files[i]), nullptr);
    EXPECT_TRUE(reader.find(files[i])->ticks);
  }
  EXPECT_EQ(reader.find(files[0])->level, reader.find(files[2])->level) << "kept once";
  EXPECT_FALSE(reader.poll());
  reader.read({dated(file_)});
  EXPECT_TRUE(reader.poll());
  EXPECT_TRUE(reader.find(file_)->ticks);
}

TEST_F(FactsReaderTest, CanEndWhileItReads) {
  for (int i = 0; i < 5; ++i) {
    FactsReader reader;
    reader.read({dated(file_)});
  }
}

TEST(ListedRun, TheDateIsThatOfUtc) {
  const auto day = std::chrono::sys_days(std::chrono::year(2026) / 2 / 28) + std::chrono::seconds(5);
  EXPECT_EQ(dateText(std::chrono::file_clock::from_sys(day)), "2026-02-28");
  EXPECT_EQ(dateText(std::chrono::file_clock::from_sys(day + std::chrono::hours(24))), "2026-03-01");
}

class RunListTest : public testing::Test {
 protected:
  RunListTest() {
    followed_.hold(30, 0);
    followed_.holdToGoal(300, Input::kRight);
  }
  fs::path write(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
    fs::create_directories(ghosts_);
    writeText(ghosts_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return ghosts_ / name;
  }
  void readAll() {
    EXPECT_TRUE(waitUntil([&] {
      list_.poll();
      return std::all_of(list_.runs().begin(), list_.runs().end(), [](const ListedRun& run) { return run.isRead; });
    }));
  }
  void load() {
    list_.load();
    readAll();
  }
  ListedRun describe(const fs::path& file) {
    list_.load();
    const std::size_t index = list_.indexOf(file);
    readAll();
    return list_.runs()[index];
  }
  const TemporaryFolder folder_;
  const fs::path ghosts_ = folder_ / "ghosts";
  RunStore store_{folder_ / "runs"};
  RunList list_{store_, ghosts_};
  FollowedGame followed_{
      levelOf("# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n")};
};

TEST_F(RunListTest, ARunOfAFriendHasTheNameOfItsFile) {
  const ListedRun run = describe(write("Anna.recording", followed_.run->recording));
  EXPECT_EQ(run.who, "Anna");
  ASSERT_TRUE(run.level);
  EXPECT_EQ(run.level->title, "Floor");
  EXPECT_EQ(run.ticks, followed_.time);
  EXPECT_EQ(run.note, "");
}

// A name says nothing of what was played.
TEST_F(RunListTest, AnOwnFileThatShowsNoRunHasNoTimeAndIsNotTheBest) {
  store_.keep(*followed_.run);
  const fs::path forged = folder_ / "runs" / RunStore::fileNameOf(followed_.game.level().hash, 6);
  const auto bytes = forgedRun(followed_.game.sharedLevel(), units(60));
  writeText(forged, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  load();
  ASSERT_EQ(list_.runs().size(), 2U);
  for (const ListedRun& run : list_.runs()) {
    EXPECT_EQ(run.ticks, run.file == forged ? std::nullopt : followed_.time);
    EXPECT_EQ(run.isBest, run.file != forged);
    EXPECT_EQ(run.noRun.substr(0, 10), run.file == forged ? "is no run:" : "");
  }
}

TEST_F(RunListTest, ARenamedRunIsTheBestOnlyByItsOwnTimeAndLevel) {
  store_.keep(*followed_.run);
  FollowedGame slow(followed_.game.sharedLevel());
  slow.hold(60, Input::kLeft);
  slow.holdToGoal(300, Input::kRight);
  FollowedGame other(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 50 -190"));
  other.holdToGoal(300, Input::kRight);
  ASSERT_GT(slow.run->ticks, followed_.run->ticks);
  ASSERT_LT(other.run->ticks, followed_.run->ticks);
  const std::uint64_t hash = followed_.game.level().hash;
  const auto writeAs = [&](std::uint32_t ticks, const platon::Run& run) {
    writeText(folder_ / "runs" / RunStore::fileNameOf(hash, ticks),
              {reinterpret_cast<const char*>(run.recording.data()), run.recording.size()});
  };
  writeAs(1, *slow.run);
  writeAs(2, *other.run);
  load();
  ASSERT_EQ(list_.runs().size(), 3U);
  for (const ListedRun& run : list_.runs())
    EXPECT_EQ(run.isBest, run.file == store_.fileOf(*followed_.run)) << run.file;
}

TEST_F(RunListTest, AFileWithTheNameOfAKeptRunIsThatOfAFriend) {
  EXPECT_EQ(describe(write(RunStore::fileNameOf(1, 5), followed_.run->recording)).who, "a friend");
}

TEST_F(RunListTest, BeforeItIsReadARunHasTheTimeAndDateOfItsFile) {
  store_.keep(*followed_.run);
  const auto noon = std::chrono::sys_days(std::chrono::year(2026) / 2 / 28) + std::chrono::seconds(12 * 3600);
  fs::last_write_time(store_.all().at(0).file, std::chrono::file_clock::from_sys(noon));
  list_.load();
  ASSERT_EQ(list_.runs().size(), 1U);
  EXPECT_FALSE(list_.runs()[0].isRead);
  EXPECT_EQ(list_.runs()[0].level, nullptr);
  EXPECT_EQ(list_.runs()[0].ticks, followed_.time);
  EXPECT_EQ(list_.runs()[0].date, "2026-02-28");
  EXPECT_TRUE(list_.runs()[0].isBest);
  readAll();
  EXPECT_EQ(list_.runs()[0].level->title, "Floor");
  EXPECT_EQ(list_.runs()[0].ticks, followed_.time);
  list_.load();
  EXPECT_TRUE(list_.runs()[0].isRead) << "it is remembered";
}

TEST_F(RunListTest, OwnRunsComeFirstAndThoseOfOthersNewestFirst) {
  store_.keep(*followed_.run);
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(write("Old", followed_.run->recording), now - std::chrono::hours(48));
  fs::last_write_time(write("New", followed_.run->recording), now);
  load();
  ASSERT_EQ(list_.runs().size(), 3U);
  EXPECT_EQ(list_.runs()[0].who, "");
  EXPECT_TRUE(list_.runs()[0].isBest);
  EXPECT_EQ(list_.runs()[1].who, "New");
  EXPECT_EQ(list_.runs()[2].who, "Old");
  EXPECT_EQ(list_.listed(), 3U);
  RunList alone(store_, {});
  alone.load();
  EXPECT_EQ(alone.runs().size(), 1U);
}

TEST_F(RunListTest, ADamagedRunAndOneOnAServerAreNotTheBest) {
  store_.keep(*followed_.run);
  RunStore(folder_ / "runs", "server").keep(*followed_.run);
  writeText(folder_ / "runs" / RunStore::fileNameOf(followed_.run->level->hash, 1), "damaged");
  load();
  ASSERT_EQ(list_.runs().size(), 3U);
  for (const ListedRun& run : list_.runs()) {
    const bool isOwn = run.file.parent_path() == folder_ / "runs";
    EXPECT_EQ(run.isBest, isOwn && run.note.empty()) << run.file;
    EXPECT_EQ(run.note.empty(), run.ticks == followed_.time) << run.file;
  }
}

TEST_F(RunListTest, ARunOfOlderRulesKeepsTheTimeOfItsName) {
  const auto older = asOfOlderRules(followed_.run->recording, followed_.game.level());
  fs::create_directories(folder_ / "runs");
  const std::string name = "0123456789abcdef-" + std::to_string(kRulesVersion - 1) + "-1.recording";
  writeText(folder_ / "runs" / name, {reinterpret_cast<const char*>(older.data()), older.size()});
  load();
  ASSERT_EQ(list_.runs().size(), 1U);
  EXPECT_EQ(list_.runs()[0].level->title, "Floor");
  EXPECT_EQ(list_.runs()[0].ticks, 1U);
  EXPECT_EQ(list_.runs()[0].note, otherRulesText(kRulesVersion - 1));
  EXPECT_FALSE(list_.runs()[0].isBest);
}

TEST_F(RunListTest, ARecordingElsewhereIsAddedOnce) {
  const fs::path file = write("Anna.recording", followed_.run->recording);
  RunList list(store_, {});
  list.load();
  EXPECT_EQ(list.indexOf(file), 0U);
  EXPECT_EQ(list.indexOf(file), 0U);
  EXPECT_EQ(list.listed(), 0U);
  EXPECT_EQ(list.indexOf(ghosts_ / "missing"), 1U);
  EXPECT_EQ(list.runs()[1].date, "");
}

}  // namespace
}  // namespace platon::run_list_test
