#include "client/ui/spectator.h"

#include <gtest/gtest.h>

namespace platon::spectator_test {
namespace {

PlayerDrawing playerOf(std::uint32_t slot, bool local = false) {
  PlayerDrawing player;
  player.slot = slot;
  player.local = local;
  player.name = "P" + std::to_string(slot);
  player.pose.position = {double{1} * slot, 0, 0};
  return player;
}

// Players 2 and 7, and the local player 4.
Scene sceneWith(bool arrived) {
  Scene scene;
  scene.players = {playerOf(2), playerOf(7), playerOf(4, true)};
  scene.focus = scene.players.back().pose;
  scene.attempt = AttemptDrawing{3, arrived};
  return scene;
}

double focusOf(Spectator& spectator, Scene scene) {
  spectator.direct(scene);
  return scene.focus.position.x;
}

TEST(Spectator, GoesThroughTheOthersAndBack) {
  Spectator spectator;
  EXPECT_EQ(focusOf(spectator, sceneWith(true)), 4);
  EXPECT_EQ(spectator.hint(), "E: watch another player");
  for (const double expected : {2.0, 7.0, 4.0, 2.0}) {
    spectator.next();
    EXPECT_EQ(focusOf(spectator, sceneWith(true)), expected);
    EXPECT_EQ(focusOf(spectator, sceneWith(true)), expected);
  }
  EXPECT_EQ(spectator.hint(), "watching P2 · E: next");
}

TEST(Spectator, FollowsTheLocalPlayerOnItsWay) {
  Spectator spectator;
  spectator.next();
  EXPECT_EQ(focusOf(spectator, sceneWith(false)), 4);
  EXPECT_EQ(focusOf(spectator, sceneWith(true)), 4) << "what was asked on the way is forgotten";
  spectator.next();
  focusOf(spectator, sceneWith(true));
  EXPECT_EQ(focusOf(spectator, sceneWith(false)), 4) << "a new attempt";
  EXPECT_EQ(spectator.hint(), "");
}

TEST(Spectator, LeavesAPlayerWhoHasGone) {
  Spectator spectator;
  spectator.next();
  focusOf(spectator, sceneWith(true));
  Scene scene = sceneWith(true);
  scene.players.erase(scene.players.begin());
  EXPECT_EQ(focusOf(spectator, scene), 4);
  scene.players.erase(scene.players.begin());
  spectator.next();
  EXPECT_EQ(focusOf(spectator, scene), 4);
  EXPECT_EQ(spectator.hint(), "") << "nobody to watch";
}

}  // namespace
}  // namespace platon::spectator_test
