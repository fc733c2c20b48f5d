#include "client/replay/ghost_folder.h"

#include <gtest/gtest.h>

#include "client/replay/recording_head.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::ghost_folder_test {
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

}  // namespace
}  // namespace platon::ghost_folder_test
