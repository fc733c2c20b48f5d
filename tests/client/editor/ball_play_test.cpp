#include "client/editor/ball_play.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/client/editor/test_editor.h"

namespace platon::ball_play_test {
namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;

TEST(BallPlayTest, PlaysTheGameOfTheLevel) {
  const auto level = loadLevel(TestEditor::levelText()).level;
  BallPlay play(level, Camera());
  Game game(level);
  const Input present[] = {Input{Input::kPresent}};
  game.advance(present);
  play.handle(KeyEvent{Key::kArrowRight, KeyEvent::Kind::kPress}, false);
  for (int tick = 0; tick < 30; ++tick) {
    const Input right[] = {Input{Input::kPresent | Input::kRight}};
    play.advance(kTick * 1.0001, false);
    game.advance(right);
  }
  EXPECT_EQ(play.game().hash(), game.hash());
}

TEST(BallPlayTest, NothingIsPressedWhileTheMenuIsOpen) {
  const auto level = loadLevel(TestEditor::levelText()).level;
  BallPlay play(level, Camera());
  play.handle(KeyEvent{Key::kArrowRight, KeyEvent::Kind::kPress}, false);
  const Point before = play.game().world().entities()[0].position;
  for (int tick = 0; tick < 30; ++tick) play.advance(kTick, true);
  EXPECT_EQ(play.game().world().entities()[0].position.x, before.x);
}

// Before, a ball that fell round the solid fell for ever.
TEST(BallPlayTest, AFallThatDoesNotEndLeadsBackToTheStartAsInTheGame) {
  BallPlay play(loadLevel("HEXAHEDRON\n0 0 0 0\n4 200 200\n480\n%\n%\n%\n%\n%\n%\n").level, Camera());
  int restarts = 0;
  for (int tick = 0; tick < 3000 && restarts == 0; ++tick) {
    play.advance(kTick, false);
    if ((play.game().player(0).held & Input::kRestart) != 0) ++restarts;
  }
  EXPECT_EQ(restarts, 1);
}

TEST(BallPlayTest, ThePictureMovesBetweenTheTicks) {
  BallPlay play(loadLevel(TestEditor::levelText()).level, Camera());
  play.handle(KeyEvent{Key::kArrowRight, KeyEvent::Kind::kPress}, false);
  for (int tick = 0; tick < 30; ++tick) play.advance(kTick, false);
  const glm::dvec3 before = play.scene().focus.position;
  const std::uint32_t tick = play.game().tick();
  play.advance(kTick / 2, false);
  const glm::dvec3 between = play.scene().focus.position;
  play.advance(kTick / 2, false);
  EXPECT_LE(play.game().tick(), tick + 1);
  EXPECT_GT(glm::distance(before, between), 0.5);
  EXPECT_NEAR(glm::distance(before, between), glm::distance(between, play.scene().focus.position), 0.1);
}

}  // namespace
}  // namespace platon::ball_play_test
