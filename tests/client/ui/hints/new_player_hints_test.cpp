#include "client/ui/hints/new_player_hints.h"

#include <gtest/gtest.h>

#include "platon/exact/integer.h"
#include "platon/game/game.h"

namespace platon::new_player_hints_test {
namespace {

std::shared_ptr<const Level> floorLevel() {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n0 0 -188 0\n3 0 0\n480\n%\n-150 -200 240 -200\n-150 -200 -150 100\n%\n%\n%\n%\n%\n");
  return result.level;
}

// A game with one player on a floor between a wall and an edge.
class FirstKeysTest : public testing::Test {
 protected:
  void play(std::uint8_t buttons, std::uint32_t ticks) {
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
      game_.advance({&input, 1});
      keys_.observe(game_.player(0), game_.world().entities()[0].part);
    }
  }

  Game game_{floorLevel()};
  FirstKeys keys_{false};
};

TEST_F(FirstKeysTest, EachIsShownUntilItIsDone) {
  play(0, 60);
  EXPECT_EQ(keys_.hint(KeyHints()), "← → or A D: run");
  play(Input::kRight, 10);
  EXPECT_EQ(keys_.hint(KeyHints()), "← → or A D: run") << "the ball has hardly moved";
  play(Input::kRight, 20);
  EXPECT_EQ(keys_.hint(KeyHints()), "Space: jump. Hold it to jump higher");
  play(Input::kJump, 60);
  EXPECT_EQ(keys_.hint(KeyHints()), "Run over the edge to the next face");
  play(0, 600);
  EXPECT_EQ(keys_.hint(KeyHints()), "Run over the edge to the next face");
  play(Input::kRight, 120);
  EXPECT_EQ(keys_.hint(KeyHints()), "After an edge an arrow shows where down is now: a wall may become a floor");
  play(0, 5 * kTicksPerSecond);
  EXPECT_EQ(keys_.hint(KeyHints()), "The goal is a glowing ring. From other faces a beam of light shows it");
  play(0, 5 * kTicksPerSecond);
  EXPECT_EQ(keys_.hint(KeyHints()), "Esc: pause, settings, back to the title");
  EXPECT_EQ(keys_.hint(KeyHints(Bindings(), true)), "Start: pause, settings, back to the title");
  play(0, 5 * kTicksPerSecond);
  EXPECT_TRUE(keys_.done());
  EXPECT_EQ(keys_.hint(KeyHints()), "");
}

TEST_F(FirstKeysTest, WhoHasCrossedAnEdgeBeforeIsNotToldHow) {
  play(Input::kRight, 120);
  ASSERT_EQ(keys_.hint(KeyHints()), "Space: jump. Hold it to jump higher");
  play(Input::kRestart, 1);
  play(0, 30);
  play(Input::kJump, 60);
  EXPECT_EQ(keys_.hint(KeyHints()), "After an edge an arrow shows where down is now: a wall may become a floor");
}

TEST_F(FirstKeysTest, AKeyThatMovesNothingIsNotEnough) {
  play(Input::kLeft | Input::kRight, 120);
  EXPECT_EQ(keys_.hint(KeyHints()), "← → or A D: run");
}

TEST_F(FirstKeysTest, ATappedJumpIsNotEnough) {
  play(Input::kRight, 30);
  play(0, 30);
  for (int tap = 0; tap < 5; ++tap) {
    play(Input::kJump, 2);
    play(0, 60);
  }
  EXPECT_EQ(keys_.hint(KeyHints()), "Space: jump. Hold it to jump higher");
}

TEST_F(FirstKeysTest, WhoPushesAgainstAWallIsToldHowToReturn) {
  play(Input::kRight, 30);
  play(Input::kJump, 60);
  play(Input::kLeft, 120);
  EXPECT_NE(keys_.hint(KeyHints()), "Stuck? R: back to the start");
  play(Input::kLeft, 3 * kTicksPerSecond);
  EXPECT_EQ(keys_.hint(KeyHints()), "Stuck? R: back to the start");
  play(Input::kRestart, 1);
  EXPECT_NE(keys_.hint(KeyHints()), "Stuck? R: back to the start");
  play(Input::kLeft, 5 * kTicksPerSecond);
  EXPECT_EQ(keys_.hint(KeyHints()), "Stuck? R: back to the start");
  play(Input::kRight, 100);
  EXPECT_NE(keys_.hint(KeyHints()), "Stuck? R: back to the start");
}

TEST_F(FirstKeysTest, WhoPushesAgainstAStepAndHasNotJumpedIsToldToJump) {
  play(Input::kRight, 30);
  play(Input::kLeft, 400);
  EXPECT_EQ(keys_.hint(KeyHints()), "Space: jump. Hold it to jump higher");
}

TEST_F(FirstKeysTest, NobodyIsStuckAtTheBeginningOfALevel) {
  play(Input::kRight, 30);
  play(Input::kJump, 60);
  play(Input::kLeft, 400);
  ASSERT_EQ(keys_.hint(KeyHints()), "Stuck? R: back to the start");
  game_ = Game(floorLevel());
  play(0, 1);
  EXPECT_NE(keys_.hint(KeyHints()), "Stuck? R: back to the start");
}

TEST_F(FirstKeysTest, NamesTheChosenKeys) {
  Bindings bindings;
  bindings.bind(Control::kJump, Key::kJ);
  play(Input::kRight, 30);
  EXPECT_EQ(keys_.hint(KeyHints(bindings)), "J: jump. Hold it to jump higher");
}

TEST_F(FirstKeysTest, WhoKnowsThemSeesNone) {
  keys_ = FirstKeys(true);
  EXPECT_TRUE(keys_.done());
  play(Input::kLeft, 600);
  EXPECT_EQ(keys_.hint(KeyHints()), "");
}

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
  EXPECT_EQ(hints_.hint(KeyHints()), "← → or A D: run");
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
  EXPECT_EQ(hints_.hint(KeyHints()), "← → or A D: run");
}

TEST_F(NewPlayerHintsTest, NobodyIsTaughtWithoutABall) {
  hints_.observe(game_, 7, settings_);
  EXPECT_EQ(textOf(settings_.untold), textOf(UntoldElements()));
}

}  // namespace
}  // namespace platon::new_player_hints_test
