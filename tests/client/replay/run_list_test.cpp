#include "client/replay/run_list.h"

#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/replay/recording_head.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
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
  std::string time() const { return finishText(double{1} * *followed_.time / kTicksPerSecond); }

  const TemporaryFolder folder_;
  const fs::path ghosts_ = folder_ / "ghosts";
  RunStore store_{folder_ / "runs"};
  FollowedGame followed_{
      levelOf("# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n")};
};

TEST_F(RunListTest, ARunOfAFriendHasTheNameOfItsFile) {
  const ListedRun run = describeRecording(write("Anna.recording", followed_.run->recording));
  EXPECT_EQ(run.who, "Anna");
  EXPECT_EQ(run.title, "Floor");
  EXPECT_EQ(run.time, time());
  EXPECT_EQ(run.rules, kRulesVersion);
  EXPECT_EQ(run.note, "");
}

TEST_F(RunListTest, AFileWithTheNameOfAKeptRunIsThatOfAFriend) {
  store_.keep(*followed_.run);
  EXPECT_EQ(describeRecording(store_.all().at(0).file).who, "a friend");
}

TEST_F(RunListTest, ARoundHasNoTime) {
  const ListedRun round = describeRecording(write("round", recordGame(100, 60).recording));
  EXPECT_EQ(round.time, "");
  EXPECT_EQ(round.note, "");
}

TEST_F(RunListTest, SaysWhatCannotBePlayed) {
  EXPECT_EQ(describeRecording(write("text", {1, 2, 3})).note, "is not a recording");
  EXPECT_EQ(describeRecording(ghosts_ / "missing").note, "is not a recording");
  const auto older = asOfOlderRules(followed_.run->recording, followed_.game.level());
  EXPECT_EQ(describeRecording(write("older", older)).note, otherRulesText(kRulesVersion - 1));
}

TEST_F(RunListTest, OwnRunsComeFirstAndThoseOfOthersNewestFirst) {
  store_.keep(*followed_.run);
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(write("Old", followed_.run->recording), now - std::chrono::hours(48));
  fs::last_write_time(write("New", followed_.run->recording), now);
  const std::vector<ListedRun> list = listRecordings(store_, ghosts_);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].who, "");
  EXPECT_TRUE(list[0].isBest);
  EXPECT_EQ(list[1].who, "New");
  EXPECT_EQ(list[2].who, "Old");
  EXPECT_EQ(listRecordings(store_, {}).size(), 1U);
}

}  // namespace
}  // namespace platon
