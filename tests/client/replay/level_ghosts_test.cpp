#include "client/replay/level_ghosts.h"

#include <gtest/gtest.h>

#include "client/replay/replay.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::level_ghosts_test {
namespace {

class GhostFolderTest : public testing::Test {
 protected:
  GhostFolderTest() {
    followed_.hold(30, 0);
    followed_.holdToGoal(300, Input::kRight);
  }

  void write(const std::string& name, const std::vector<std::uint8_t>& bytes) {
    writeText(folder_ / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  std::vector<Ghost> ghosts() {
    faults_.clear();
    return ghostsIn(folder_.path(), followed_.game.level(), 3, faults_);
  }

  const TemporaryFolder folder_;
  FollowedGame followed_{cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190")};
  std::vector<std::string> faults_;
};

TEST_F(GhostFolderTest, TheFirstFilesOfTheLevelAreGhostsWithTheirNames) {
  for (const char* const name : {"dora.recording", "bob.recording", "carla.recording", "anna.recording"}) {
    write(name, followed_.run->recording);
  }
  write("abel.recording", recordGame(100, 60).recording);  // on another level
  const std::vector<Ghost> found = ghosts();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "anna");
  EXPECT_EQ(found[1].name, "bob");
  EXPECT_EQ(found[2].name, "carla");
  EXPECT_EQ(found[0].track->ticks, *followed_.time);
  EXPECT_TRUE(faults_.empty());
}

TEST_F(GhostFolderTest, WhatCannotBeAGhostIsNamed) {
  std::vector<std::uint8_t> damaged = followed_.run->recording;
  damaged.back() ^= 1;
  write("damaged", damaged);
  write("older", asOfOlderRules(followed_.run->recording, followed_.game.level()));
  Recorder recorder{Game(followed_.game.sharedLevel())};
  recorder.finish(Game(followed_.game.sharedLevel()));
  write("round", recorder.takeBytes());
  EXPECT_TRUE(ghosts().empty());
  ASSERT_EQ(faults_.size(), 3U);
  EXPECT_NE(faults_[0].find("is a damaged recording"), std::string::npos);
  EXPECT_NE(faults_[1].find(otherRulesText(kRulesVersion - 1)), std::string::npos);
  EXPECT_NE(faults_[2].find("is no run"), std::string::npos);
}

// A recording of other rules costs nothing, one that turns out to be no run may cost as much as any.
TEST_F(GhostFolderTest, ManyForgedRecordingsAreNotAllPlayed) {
  const auto forged = forgedRun(followed_.game.sharedLevel(), units(60));
  for (std::size_t i = 0; i < kMaxPlayedInVain; ++i) {
    write("a" + std::to_string(i), asOfOlderRules(followed_.run->recording, followed_.game.level()));
    write("b" + std::to_string(i), forged);
  }
  EXPECT_TRUE(ghosts().empty());
  EXPECT_EQ(faults_.size(), 2 * kMaxPlayedInVain);
  write("c", followed_.run->recording);
  EXPECT_TRUE(ghosts().empty());
  ASSERT_EQ(faults_.size(), 2 * kMaxPlayedInVain + 1);
  EXPECT_EQ(faults_.back(), playedInVain(folder_.path()));
  write("a0", followed_.run->recording);
  EXPECT_EQ(ghosts().size(), 1U);
}

TEST_F(GhostFolderTest, ANameThatCannotBeShownIsLeftOut) {
  write("\x80.recording", followed_.run->recording);
  ASSERT_EQ(ghosts().size(), 1U);
  EXPECT_EQ(ghosts()[0].name, "");
}

TEST_F(GhostFolderTest, WithoutAFolderThereAreNone) {
  EXPECT_TRUE(ghostsIn({}, followed_.game.level(), 3, faults_).empty());
  EXPECT_TRUE(ghostsIn(folder_ / "missing", followed_.game.level(), 3, faults_).empty());
  EXPECT_TRUE(faults_.empty());
}

class LevelGhostsTest : public testing::Test {
 protected:
  LevelGhostsTest() {
    followed_.hold(30, 0);
    followed_.holdToGoal(300, Input::kRight);
  }
  const Level& level() const { return followed_.game.level(); }
  const platon::Run& run() const { return *followed_.run; }
  std::string bestName() const { return "best " + finishText(double{1} * run().ticks / kTicksPerSecond); }
  // An own run with a name of this time.
  std::filesystem::path write(std::uint32_t ticks, const std::vector<std::uint8_t>& recording) const {
    const auto file = folder_ / "runs" / RunStore::fileNameOf(level().hash, ticks);
    writeText(file, {reinterpret_cast<const char*>(recording.data()), recording.size()});
    return file;
  }
  std::filesystem::path copyTo(const std::string& name) const {
    std::filesystem::create_directories(folder_ / "ghosts");
    const auto file = folder_ / "ghosts" / name;
    writeText(file, {reinterpret_cast<const char*>(run().recording.data()), run().recording.size()});
    return file;
  }

  const TemporaryFolder folder_;
  FollowedGame followed_{cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190")};
  // As a match reads them: first the best run, then two of others.
  LevelGhosts readGhosts(const std::stop_token& stop = {}) const {
    LevelGhosts ghosts = readBestGhost(best_, level(), stop);
    LevelGhosts others = readOtherGhosts({folder_ / "ghosts", rival_, ghosts.bestFile}, level(), 2, stop);
    ghosts.others = std::move(others.others);
    for (std::string& fault : others.faults) ghosts.faults.push_back(std::move(fault));
    return ghosts;
  }

  BestRunSource best_{RunStore(folder_ / "runs"), nullptr};
  std::filesystem::path rival_;
};

TEST_F(LevelGhostsTest, TheBestRunAndOthersAreRead) {
  best_.own.keep(run());
  for (const char* const name : {"anna", "bob", "carla"}) copyTo(name);
  const LevelGhosts ghosts = readGhosts();
  ASSERT_TRUE(ghosts.best);
  EXPECT_EQ(ghosts.best->name, bestName());
  EXPECT_EQ(ghosts.best->track->ticks, run().ticks);
  EXPECT_EQ(ghosts.bestFile, best_.own.fileOf(run()));
  ASSERT_EQ(ghosts.others.size(), 2U);
  EXPECT_EQ(ghosts.others[1].name, "bob");
  EXPECT_TRUE(ghosts.faults.empty());
}

TEST_F(LevelGhostsTest, ARunThatIsNotWrittenYetIsTheBest) {
  best_.unsaved = std::make_shared<const platon::Run>(run());
  const LevelGhosts ghosts = readGhosts();
  ASSERT_TRUE(ghosts.best);
  EXPECT_EQ(ghosts.best->name, bestName());
  EXPECT_EQ(ghosts.bestFile, std::filesystem::path());
}

TEST_F(LevelGhostsTest, TheRivalComesFirstAndOnce) {
  copyTo("anna");
  rival_ = copyTo("bob");
  const LevelGhosts ghosts = readGhosts();
  ASSERT_EQ(ghosts.others.size(), 2U);
  EXPECT_EQ(ghosts.others[0].name, "bob");
  EXPECT_EQ(ghosts.others[1].name, "anna");
}

TEST_F(LevelGhostsTest, ADamagedBestRunIsNamedOnceAlsoAsTheRival) {
  best_.own.keep(run());
  rival_ = best_.own.fileOf(run());
  writeText(rival_, "damaged");
  const LevelGhosts ghosts = readGhosts();
  EXPECT_FALSE(ghosts.best);
  ASSERT_EQ(ghosts.faults.size(), 1U);
  EXPECT_EQ(ghosts.faults[0].find(rival_.string()), 0U);
}

TEST_F(LevelGhostsTest, AFileThatIsNoRunLeavesItsPlaceToTheNext) {
  best_.own.keep(run());
  const auto forged = write(6, forgedRun(followed_.game.sharedLevel(), units(60)));
  const auto damaged = write(7, {1, 2, 3});
  write(run().ticks + 1, {1, 2, 3});  // slower: not looked at
  const LevelGhosts ghosts = readGhosts();
  ASSERT_TRUE(ghosts.best);
  EXPECT_EQ(ghosts.best->name, bestName());
  EXPECT_EQ(ghosts.bestFile, best_.own.fileOf(run()));
  ASSERT_EQ(ghosts.faults.size(), 2U);
  EXPECT_EQ(ghosts.faults[0],
            forged.string() + ": is no run: its player does not begin at the start of the level, at rest");
  EXPECT_EQ(ghosts.faults[1].find(damaged.string()), 0U);
}

// Names of files are no proof.
TEST_F(LevelGhostsTest, ARenamedRunHidesNoFasterOne) {
  best_.own.keep(run());
  FollowedGame slow(followed_.game.sharedLevel());
  slow.hold(60, Input::kLeft);
  slow.holdToGoal(300, Input::kRight);
  ASSERT_GT(slow.run->ticks, run().ticks);
  write(6, slow.run->recording);
  const LevelGhosts ghosts = readGhosts();
  ASSERT_TRUE(ghosts.best);
  EXPECT_EQ(ghosts.best->name, bestName());
  EXPECT_EQ(ghosts.bestFile, best_.own.fileOf(run()));
}

// Each of them may cost as much as a recording is allowed to.
TEST_F(LevelGhostsTest, ManyForgedFilesAreNotAllPlayedAtTheStartOfALevel) {
  best_.own.keep(run());
  const auto forged = forgedRun(followed_.game.sharedLevel(), units(60));
  std::uint32_t ticks = 1;
  for (; ticks < kMaxPlayedInVain; ++ticks) write(ticks, forged);
  EXPECT_TRUE(readGhosts().best);
  write(ticks, forged);
  const LevelGhosts ghosts = readGhosts();
  EXPECT_FALSE(ghosts.best);
  ASSERT_EQ(ghosts.faults.size(), kMaxPlayedInVain + 1);
  EXPECT_EQ(ghosts.faults.back(), playedInVain(folder_ / "runs"));
}

TEST_F(LevelGhostsTest, AStopReadsNothingMore) {
  copyTo("anna");
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(readGhosts(stop.get_token()).others.empty());
}

}  // namespace
}  // namespace platon::level_ghosts_test
