#include "client/ui/hints/new_player_hints.h"

#include <optional>
#include <string>

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

constexpr const char* kGoal = "The goal is the glowing ring. A beam of light shows where it is";

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
  EXPECT_EQ(keys_.hint(KeyHints()), kGoal);
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
  EXPECT_EQ(keys_.hint(KeyHints()), kGoal);
}

TEST_F(FirstKeysTest, WhoReachesAGoalKnowsAll) {
  PlayerState player;
  player.arrived = 60;
  keys_.observe(player, 0);
  EXPECT_TRUE(keys_.done());
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

// A game with one player, observed by the hints.
class NewPlayerHintsTest : public testing::Test {
 protected:
  void begin(const std::string& level, bool known = true) {
    const LevelResult result = loadLevel(level);
    ASSERT_TRUE(result.level);
    game_.emplace(result.level);
    settings_.firstKeys = !known;
  }
  void play(std::uint8_t buttons, std::uint32_t ticks, bool looks = false) {
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
      game_->advance({&input, 1});
      hints_.observe(*game_, 0, looks, settings_);
    }
  }
  std::string hint() const { return hints_.hint(KeyHints()); }

  Settings settings_;
  NewPlayerHints hints_{settings_};
  std::optional<Game> game_;
};

// A floor between a wall and an edge.
constexpr const char* kFloor =
    "HEXAHEDRON\n0 0 -188 0\n0 0 200\n480\n%\n-150 -200 240 -200\n-150 -200 -150 100\n%\n%\n%\n%\n%\n";
// The same with a key at the left end, a door out of the way, and the goal on another face.
constexpr const char* kKeyFloor =
    "HEXAHEDRON\n0 0 -188 0\n3 0 0\n480\n%\n-150 -200 240 -200\n-150 -200 -150 100\n"
    "-100 -190 -100 -180 key 1\n-200 90 -200 100 door 1\n%\n%\n%\n%\n%\n";
constexpr const char* kKey = "A key opens all doors with its number";
constexpr const char* kDoor = "A door opens with the key of its number";
constexpr const char* kLook = "Hold Tab and press arrows: look round for a way to the goal";
constexpr const char* kDown = "Down has turned: a wall may be a floor now";
constexpr const char* kStuck = "Stuck? R: back to the start";

TEST_F(NewPlayerHintsTest, TheKeysAndTheElementsOfALevelTakeTurns) {
  begin(kKeyFloor, false);
  play(0, 60);
  EXPECT_EQ(hint(), "← → or A D: run");
  play(0, 8 * kTicksPerSecond - 60);
  EXPECT_EQ(hint(), kKey) << "who is not asked to run is told of the level";
  play(0, 8 * kTicksPerSecond);
  EXPECT_EQ(hint(), "← → or A D: run");
  play(Input::kRight, 30);
  EXPECT_EQ(hint(), "Space: jump. Hold it to jump higher");
}

TEST_F(NewPlayerHintsTest, AnElementIsToldWhenTheBallMeetsIt) {
  begin(kKeyFloor, false);
  play(Input::kLeft, 60);
  EXPECT_EQ(hint(), kKey) << "before the first keys";
  play(0, 4 * kTicksPerSecond);
  EXPECT_EQ(hint(), "Space: jump. Hold it to jump higher");
  EXPECT_EQ(settings_.untold.mask & 1u << static_cast<unsigned>(ElementKind::kKey), 0U);
}

TEST_F(NewPlayerHintsTest, WhoKnowsTheKeysIsToldOfTheElementsUntilItHasMetThem) {
  begin(kKeyFloor);
  settings_.firstLook = false;
  play(0, 1);
  EXPECT_EQ(hint(), kKey);
  play(Input::kRestart, 1);
  EXPECT_EQ(hint(), kKey) << "a restart does not end it";
  play(Input::kLeft, 60);
  play(0, 4 * kTicksPerSecond);
  EXPECT_EQ(hint(), kDoor);
}

TEST_F(NewPlayerHintsTest, LookingRoundIsToldWhileTheGoalIsOnAnotherFaceUntilThePlayerDoesIt) {
  begin(kFloor);
  play(0, 60);
  EXPECT_EQ(hint(), "") << "the goal is on this face";
  begin(kKeyFloor);
  play(0, 60 * kTicksPerSecond);
  EXPECT_EQ(hint(), kLook) << "who has not begun reads on";
  EXPECT_EQ(hints_.hint(KeyHints(Bindings(), true)), "right stick: look round for a way to the goal");
  play(0, kTicksPerSecond / 3, true);
  EXPECT_FALSE(settings_.firstLook);
  EXPECT_EQ(hint(), kKey);
}

TEST_F(NewPlayerHintsTest, WhoPlaysOnWithoutLookingRoundIsToldItFor15Seconds) {
  begin(kKeyFloor);
  play(Input::kRight, 5);
  play(0, 15 * kTicksPerSecond - 10);
  EXPECT_EQ(hint(), kLook);
  play(0, 10);
  EXPECT_EQ(hint(), kKey);
}

// Right over edge 1, down a shaft over face 5, and back to face 0 with down at its left.
TEST_F(NewPlayerHintsTest, ThatDownHasTurnedIsToldWhenTheBallComesBackToAFace) {
  begin(
      "HEXAHEDRON\n0 -90 -128 0\n0 -172 140\n480\n%\n-200 200 -200 -242\n-200 200 -100 200\n-200 60 -180 60\n"
      "-140 -20 -140 -140\n-140 -140 242 -140\n%\n-242 -140 -180 -140\n-180 -140 -180 -240\n-100 0 -100 -242\n%\n%\n%\n"
      "%\n-200 242 -200 100\n242 100 -200 100\n");
  settings_.firstLook = false;
  play(Input::kRight, 4 * kTicksPerSecond);
  ASSERT_EQ(game_->world().entities()[0].part, 5U) << "the ball stands at the end of the shaft";
  EXPECT_NE(hint(), kDown) << "each face was new";
  for (int tick = 0; tick < 300 && game_->world().entities()[0].part != 0; ++tick) play(Input::kLeft, 1);
  EXPECT_EQ(hint(), kDown);
  play(0, 5 * kTicksPerSecond - 2);
  EXPECT_EQ(hint(), kDown);
  play(0, 2);
  EXPECT_NE(hint(), kDown);
  EXPECT_FALSE(settings_.firstDown);
}

TEST_F(NewPlayerHintsTest, WhoCrossesAnEdgeToAndFroIsNotToldThatDownHasTurned) {
  begin("HEXAHEDRON\n0 0 -188 0\n0 0 200\n480\n%\n-150 -200 242 -200\n%\n-242 -200 200 -200\n%\n%\n%\n%\n");
  play(Input::kRight, 120);
  ASSERT_EQ(game_->world().entities()[0].part, 1U);
  play(Input::kLeft, 120);
  ASSERT_EQ(game_->world().entities()[0].part, 0U);
  EXPECT_TRUE(settings_.firstDown);
  EXPECT_NE(hint(), kDown);
}

TEST_F(NewPlayerHintsTest, WhoPushesAgainstAWallIsToldHowToReturn) {
  begin(kFloor);
  play(Input::kLeft, 120);
  EXPECT_NE(hint(), kStuck);
  play(Input::kLeft, 3 * kTicksPerSecond);
  EXPECT_EQ(hint(), kStuck);
  play(Input::kRestart, 1);
  EXPECT_NE(hint(), kStuck);
  play(Input::kLeft, 60 * kTicksPerSecond);
  EXPECT_EQ(hint(), kStuck);
  play(Input::kRight, kTicksPerSecond);
  EXPECT_NE(hint(), kStuck) << "a second of rolling ends it, however long it was";
}

TEST_F(NewPlayerHintsTest, WhoPushesAgainstAStepAndHasNotJumpedIsToldToJump) {
  begin(kFloor, false);
  play(Input::kRight, 30);
  play(Input::kLeft, 400);
  EXPECT_EQ(hint(), "Space: jump. Hold it to jump higher");
}

TEST_F(NewPlayerHintsTest, NobodyIsStuckAtTheBeginningOfALevel) {
  begin(kFloor);
  play(Input::kLeft, 400);
  ASSERT_EQ(hint(), kStuck);
  begin(kFloor);
  play(0, 1);
  EXPECT_NE(hint(), kStuck);
}

TEST_F(NewPlayerHintsTest, TurnedOffOrAllKnownThereIsNone) {
  begin(kKeyFloor);
  settings_.untold = {0};
  play(Input::kLeft, 400);
  EXPECT_EQ(hint(), "") << "nothing of later releases either";
  EXPECT_TRUE(settings_.firstLook && settings_.firstDown);
}

TEST_F(NewPlayerHintsTest, TurnedOnAgainTheyBeginAnew) {
  begin(kFloor);
  settings_.untold = {0};
  play(0, 60);
  EXPECT_EQ(hint(), "");
  settings_.firstKeys = true;
  play(0, 1);
  EXPECT_EQ(hint(), "← → or A D: run");
}

TEST_F(NewPlayerHintsTest, NobodyIsTaughtWithoutABall) {
  begin(kKeyFloor);
  hints_.observe(*game_, 7, false, settings_);
  EXPECT_EQ(hint(), "");
  EXPECT_EQ(textOf(settings_.untold), textOf(UntoldElements()));
}

}  // namespace
}  // namespace platon::new_player_hints_test
