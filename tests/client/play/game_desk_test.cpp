#include "client/play/game_desk.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "client/time/steady_now.h"
#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::game_desk_test {
namespace {

class GameDeskTest : public testing::Test {
 protected:
  ClientOptions options() const {
    ClientOptions options;
    options.screenshot = (folder_ / "picture.png").string();
    return options;
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable config_{"XDG_CONFIG_HOME", folder_.path()};
  const EnvironmentVariable pictures_{"XDG_PICTURES_DIR", folder_.path()};
  DesktopWindow window_ = openWindow("");
  GameDesk desk_{options(), steadyClock(), window_};
};

// The name of the game and the message are brighter than the sky behind them.
TEST_F(GameDeskTest, SaysThatItLoads) {
  const Image picture = desk_.view.read();
  EXPECT_GT(*std::max_element(picture.pixels.begin(), picture.pixels.end()), 240);
}

TEST_F(GameDeskTest, TellsForFourSeconds) {
  desk_.tell("done");
  desk_.update({steadyClock().now(), 3.9});
  EXPECT_EQ(desk_.told(), "done");
  desk_.update({steadyClock().now(), 0.2});
  EXPECT_EQ(desk_.told(), "");
}

TEST_F(GameDeskTest, FinishesWithThePictureAndTheSettings) {
  desk_.settings().zoom = 2;
  desk_.finish();
  EXPECT_EQ(SettingsFile(configFolder()).load().zoom, 2);
  EXPECT_GT(std::filesystem::file_size(folder_ / "picture.png"), 1000U);
}

TEST(NamedPlay, OnlyWhatTheCommandLineNamesDecidesHowTheProgramEnds) {
  const ProgramError error(ProgramError::kInvalid, "no level");
  NamedPlay other;
  EXPECT_FALSE(other.fail(error));
  EXPECT_FALSE(other.failure);
  NamedPlay named{.pending = true};
  EXPECT_FALSE(named.fail(error));
  EXPECT_TRUE(named.failure);
  named.succeed();
  EXPECT_FALSE(named.failure);
  EXPECT_FALSE(named.fail(error)) << "something else was played";
  EXPECT_FALSE(named.failure);
  EXPECT_TRUE((NamedPlay{.limited = true, .pending = true}).fail(error));
}

}  // namespace
}  // namespace platon::game_desk_test
