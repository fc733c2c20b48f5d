#include "client/editor/ball_play.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/client/editor/test_editor.h"

namespace platon::ball_play_test {
namespace {

TEST(BallPlayTest, PlaysTheGameOfTheLevel) {
  const auto level = loadLevel(TestEditor::levelText()).level;
  BallPlay play(level);
  Game game(level);
  const Input present[] = {Input{Input::kPresent}};
  game.advance(present);
  for (int tick = 0; tick < 30; ++tick) {
    const Input right[] = {Input{Input::kPresent | Input::kRight}};
    play.tick(Input{Input::kRight});
    game.advance(right);
  }
  EXPECT_EQ(play.game().hash(), game.hash());
}

TEST(BallPlayTest, ThePictureMovesBetweenTheTicks) {
  BallPlay play(loadLevel(TestEditor::levelText()).level);
  for (int tick = 0; tick < 30; ++tick) play.tick(Input{Input::kRight});
  const glm::dvec3 before = play.scene(0).focus.position;
  const glm::dvec3 between = play.scene(0.5).focus.position;
  const glm::dvec3 now = play.scene(1).focus.position;
  EXPECT_GT(glm::distance(before, now), 1);
  EXPECT_NEAR(glm::distance(before, between), glm::distance(before, now) / 2, 1e-6);
}

}  // namespace
}  // namespace platon::ball_play_test
