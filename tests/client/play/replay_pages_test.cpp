#include "client/play/replay_pages.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/ui/font.h"
#include "client/ui/player_rows.h"
#include "tests/client/replay/followed_game.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::replay_pages_test {
namespace {

namespace fs = std::filesystem;

FollowedGame gameToGoal(const std::string& players = "") {
  FollowedGame game(levelOf(players + "# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 "
                                      "-200\n%\n%\n%\n%\n%\n"));
  game.hold(30, 0);
  game.holdToGoal(300, Input::kRight);
  return game;
}

class ReplayPagesTest : public testing::Test {
 protected:
  ReplayPagesTest() {
    menu_.open([] {
      MenuPage page{"Title"};
      page.items = {{.name = "Item"}};
      return page;
    });
  }

  void write(const fs::path& file, const std::vector<std::uint8_t>& bytes) const {
    fs::create_directories(file.parent_path());
    writeText(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  void tap(Key key) { menu_.handle({key, KeyEvent::Kind::kPress}, font_); }
  bool shows(const std::string& text) {
    for (const Overlay::Text& each : menu_.overlay(font_, false).texts) {
      if (each.content.find(text) != std::string::npos) return true;
    }
    return false;
  }

  // Shows it as soon as the recordings have been read.
  bool becomes(const std::string& text) {
    return waitUntil([&] { return shows(text); });
  }

  const TemporaryFolder folder_;
  // So that the path that is shown fits a line, however long that of the folder is.
  const EnvironmentVariable home_{"HOME", folder_.path().string()};
  const fs::path ghosts_ = folder_ / "ghosts";
  const fs::path elsewhere_ = folder_ / "elsewhere/Anna.recording";
  const FollowedGame played_ = gameToGoal();
  RunStore store_{folder_ / "runs"};
  Font font_;
  Menu menu_;
  fs::path watched_;
  std::shared_ptr<const Level> racedOn_;
  std::optional<MedalTimes> medals_;
  fs::path raced_;
  std::string noRace_;
  ReplayPages pages_{menu_,
                     folder_ / "runs",
                     ghosts_,
                     {[this](const fs::path& file) { watched_ = file; },
                      [this](const std::shared_ptr<const Level>& level, const fs::path& file) {
                        racedOn_ = level;
                        raced_ = file;
                        return noRace_;
                      },
                      [this](const std::shared_ptr<const Level>&) { return medals_; }}};
};

TEST_F(ReplayPagesTest, WithoutRunsTheListSaysHowTheyGetThere) {
  pages_.showList();
  EXPECT_TRUE(shows("Reach a goal"));
  EXPECT_EQ(pages_.shownLevel(), nullptr);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Title"));
}

TEST_F(ReplayPagesTest, ARunOfTheListIsWatchedAndRaced) {
  store_.keep(*played_.run);
  const fs::path file = store_.all().at(0).file;
  pages_.showList();
  EXPECT_TRUE(becomes("Floor"));
  EXPECT_EQ(pages_.shownLevel()->title, "Floor");
  tap(Key::kEnter);
  EXPECT_TRUE(shows("send this file"));
  tap(Key::kEnter);
  EXPECT_EQ(watched_, file);
  EXPECT_FALSE(shows("Keep it")) << "it is kept";
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_EQ(raced_, file);
  EXPECT_EQ(racedOn_->hash, played_.game.level().hash);
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Your best runs"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Title"));
}

TEST_F(ReplayPagesTest, WhyThereCanBeNoRaceIsSaidOnThePage) {
  store_.keep(*played_.run);
  pages_.showList();
  EXPECT_TRUE(becomes("Floor"));
  tap(Key::kEnter);
  tap(Key::kArrowDown);
  noRace_ = "the disk is full";
  tap(Key::kEnter);
  EXPECT_TRUE(shows("The race cannot start: the disk is full."));
  noRace_.clear();
  tap(Key::kEnter);
  EXPECT_FALSE(shows("The race cannot start"));
}

TEST_F(ReplayPagesTest, ARecordingFromElsewhereIsKeptAsAGhost) {
  write(elsewhere_, played_.run->recording);
  write(ghosts_ / "Anna.recording", played_.run->recording);
  pages_.showRun(elsewhere_);
  EXPECT_TRUE(shows("Anna"));
  EXPECT_TRUE(becomes("Keep it as a ghost"));
  EXPECT_EQ(pages_.shownLevel()->title, "Floor");
  tap(Key::kArrowDown);
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_EQ(readBytes(ghosts_ / "Anna 2.recording"), played_.run->recording) << "no file is replaced";
  EXPECT_TRUE(shows("~/ghosts/Anna 2.recording"));
  EXPECT_FALSE(shows("Keep it"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Runs of others"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Title"));
}

TEST_F(ReplayPagesTest, OnAFullDiskNoPartOfACopyIsLeft) {
  write(elsewhere_, played_.run->recording);
  pages_.showRun(elsewhere_);
  EXPECT_TRUE(becomes("Keep it as a ghost"));
  tap(Key::kArrowDown);
  tap(Key::kArrowDown);
  {
    const FullDisk full(100);
    tap(Key::kEnter);
  }
  EXPECT_TRUE(shows("It cannot be kept: File too large"));
  EXPECT_TRUE(fs::is_empty(ghosts_));
}

TEST_F(ReplayPagesTest, AFailedCopySaysWhy) {
  write(elsewhere_, played_.run->recording);
  writeText(ghosts_, "a file");
  pages_.showRun(elsewhere_);
  EXPECT_TRUE(becomes("Keep it as a ghost"));
  tap(Key::kArrowDown);
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("It cannot be kept: "));
}

TEST_F(ReplayPagesTest, NobodyRacesAloneOnALevelForTwo) {
  write(elsewhere_, gameToGoal("# players: 2\n").run->recording);
  pages_.showRun(elsewhere_);
  EXPECT_TRUE(becomes("Floor"));
  EXPECT_TRUE(shows("Watch"));
  EXPECT_FALSE(shows("Race"));
}

TEST_F(ReplayPagesTest, WhatIsNoRecordingSaysSoAndIsNotWatched) {
  write(elsewhere_, {1, 2, 3});
  pages_.showRun(elsewhere_);
  EXPECT_TRUE(becomes("It is not a recording."));
  EXPECT_FALSE(shows("Level without a title")) << "its file tells more";
  EXPECT_FALSE(shows("Watch"));
  EXPECT_EQ(pages_.shownLevel(), nullptr);
}

TEST_F(ReplayPagesTest, WhatIsKnownIsShownBeforeTheRecordingIsRead) {
  store_.keep(*played_.run);
  pages_.showList();
  EXPECT_TRUE(shows(finishTextOf(played_.run->ticks))) << "the time is in the name of the file";
  EXPECT_FALSE(shows("★")) << "only with its level its medal is known";
  EXPECT_TRUE(becomes("Floor"));
  EXPECT_TRUE(shows("★"));
}

// Before, the best run had a star, whatever its time was worth.
TEST_F(ReplayPagesTest, ARunHasTheMedalOfItsTime) {
  medals_ = MedalTimes{1, 1, 1};
  store_.keep(*played_.run);
  pages_.showList();
  EXPECT_TRUE(becomes("☆☆☆ " + finishTextOf(played_.run->ticks)));
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Your run: ☆☆☆ "));
  EXPECT_FALSE(shows("★"));
}

TEST_F(ReplayPagesTest, TheLevelIsThatOfTheLastReading) {
  store_.keep(*played_.run);
  const fs::path file = store_.all().at(0).file;
  pages_.showList();
  EXPECT_TRUE(becomes("Floor"));
  fs::remove(file);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Race"));
  EXPECT_EQ(pages_.shownLevel()->title, "Floor") << "the file is not read again";
}

TEST_F(ReplayPagesTest, OtherPagesShowNoLevelOfARecording) {
  store_.keep(*played_.run);
  pages_.showList();
  pages_.leave();
  EXPECT_EQ(pages_.shownLevel(), nullptr);
}

}  // namespace
}  // namespace platon::replay_pages_test
