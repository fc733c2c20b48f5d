#include "client/ui/hints/new_player_hints.h"

#include <gtest/gtest.h>

namespace platon::new_player_hints_test {
namespace {

// A game with one player on a floor with a key.
class NewPlayerHintsTest : public testing::Test {
 protected:
  void play(std::uint8_t buttons, std::uint32_t ticks) {
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
      game_.advance({&input, 1});
      hints_.observe(game_, 0, settings_);
    }
  }

  static std::shared_ptr<const Level> keyLevel() {
    return loadLevel(
               "HEXAHEDRON\n0 0 -188 0\n3 0 0\n480\n%\n-150 -200 240 -200\n-150 -200 -150 100\n"
               "-100 -190 -100 -180 key 1\n-200 90 -200 100 door 1\n%\n%\n%\n%\n%\n")
        .level;
  }

  Settings settings_;
  NewPlayerHints hints_{settings_};
  Game game_{keyLevel()};
};

TEST_F(NewPlayerHintsTest, KeysComeBeforeElements) {
  play(0, 60);
  EXPECT_EQ(hints_.hint(KeyHints()), "← → or A D: roll");
  settings_.firstKeys = false;  // turned off in the menu
  play(0, 1);
  EXPECT_EQ(hints_.hint(KeyHints()), "A key opens all doors with its number");
  play(Input::kRight, 600);
  EXPECT_EQ(hints_.hint(KeyHints()), "A key opens all doors with its number") << "not met";
  play(Input::kRestart, 1);
  EXPECT_EQ(hints_.hint(KeyHints()), "A key opens all doors with its number") << "a restart does not end it";
  play(Input::kLeft, 300);
  EXPECT_EQ(hints_.hint(KeyHints()), "");
  EXPECT_EQ(textOf(settings_.untold), "oneway,up,hazard,checkpoint,door,plate");
}

TEST_F(NewPlayerHintsTest, TurnedOnAgainTheyBeginAnew) {
  settings_.firstKeys = false;
  settings_.untold = {0};
  play(0, 60);
  EXPECT_EQ(hints_.hint(KeyHints()), "");
  settings_.firstKeys = true;
  play(0, 1);
  EXPECT_EQ(hints_.hint(KeyHints()), "← → or A D: roll");
}

TEST_F(NewPlayerHintsTest, NobodyIsTaughtWithoutABall) {
  hints_.observe(game_, 7, settings_);
  EXPECT_EQ(textOf(settings_.untold), textOf(UntoldElements()));
}

}  // namespace
}  // namespace platon::new_player_hints_test
