#include "client/replay/run_list.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/replay/recording_head.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::run_list_test {
namespace {

namespace fs = std::filesystem;

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
