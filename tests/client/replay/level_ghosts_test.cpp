#include "client/replay/level_ghosts.h"

#include <gtest/gtest.h>

#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::level_ghosts_test {
namespace {

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
