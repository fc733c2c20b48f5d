#include "client/play/offscreen/local_game.h"

#include <gtest/gtest.h>

#include "tests/support/test_levels.h"

namespace platon::local_game_test {
namespace {

TEST(LocalGame, TheSceneShowsAllPlayersAndFollowsTheFirst) {
  LocalGame game(flatLevel(), {"Ada", "Grace"});
  const std::vector<Input> inputs{{Input::kPresent | Input::kRight}, {Input::kPresent}};
  for (int tick = 0; tick < 30; ++tick) game.advance(inputs);
  const Scene scene = game.scene();
  ASSERT_EQ(scene.players.size(), 2U);
  EXPECT_TRUE(scene.players.back().local);
  EXPECT_EQ(scene.players.back().name, "Ada");
  EXPECT_EQ(scene.focus.position, scene.players.back().pose.position);
  ASSERT_TRUE(scene.attempt);
  EXPECT_GT(scene.attempt->seconds, 0);
}

TEST(LocalGame, OnlyAPlayerWhoIsAloneHasNoTimeLimit) {
  EXPECT_FALSE(LocalGame(flatLevel(), {"Ada"}).scene().timed);
  EXPECT_TRUE(LocalGame(flatLevel(), {"Ada", "Grace"}).scene().timed);
}

TEST(LocalGame, BeginsAnew) {
  LocalGame game(flatLevel(), {"Ada"});
  const Game fresh = game.game();
  const std::vector<Input> inputs{{Input::kPresent | Input::kRight}};
  for (int tick = 0; tick < 30; ++tick) game.advance(inputs);
  ASSERT_NE(game.game().hash(), fresh.hash());
  game.begin();
  EXPECT_EQ(game.game().hash(), fresh.hash());
  game.advance(std::vector<Input>{{Input::kPresent}});
  EXPECT_EQ(game.scene().attempt->seconds, 0);
}

}  // namespace
}  // namespace platon::local_game_test
