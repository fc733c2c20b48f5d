#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "client/play/finish_watch.h"
#include "client/play/scene_feed.h"
#include "tests/support/pressing.h"
#include "tests/support/test_level.h"
#include "tests/support/virtual_match.h"

namespace platon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };
const Controls kNothing = [](const Game&, std::uint32_t) { return Input{}; };

TEST(FinishWatch, TellsOfEveryLevelOnce) {
  VirtualMatch match({flatLevel()}, 1);
  match.join(LinkQuality(), kRight);
  FinishWatch watch;
  std::vector<std::string> lines;
  for (int step = 0; step < 200; ++step) {
    match.run(milliseconds(100));
    if (const auto line = watch.look(match.session(0))) lines.push_back(*line);
  }
  // Some two seconds to the goal and five until the next round.
  ASSERT_GE(lines.size(), 2u);
  ASSERT_LE(lines.size(), 4u);
  for (const std::string& line : lines) EXPECT_EQ(line.rfind("finished the level in 1.", 0), 0u) << line;
}

TEST(FinishWatch, SaysNothingOfOthers) {
  VirtualMatch match({flatLevel()}, 1);
  match.join(LinkQuality(), kRight);
  match.join(LinkQuality(), kNothing);
  match.run(seconds(5));
  FinishWatch runner, idler;
  EXPECT_TRUE(runner.look(match.session(0)).has_value());
  EXPECT_FALSE(runner.look(match.session(0)).has_value());
  EXPECT_FALSE(idler.look(match.session(1)).has_value());
}

TEST(SceneFeed, ShowsTheOwnPlayerAheadAndTheOthersAsConfirmed) {
  LinkQuality line;
  line.delayMs = 100;
  VirtualMatch match({endlessLevel()}, 1);
  match.join(line, kRight);
  match.join(line, kRight);
  SceneFeed feed;
  EXPECT_FALSE(feed.scene(match.session(0), match.now()).has_value());
  match.run(milliseconds(1500));
  const auto scene = feed.scene(match.session(0), match.now());
  ASSERT_TRUE(scene.has_value());
  ASSERT_EQ(scene->players.size(), 2u);
  const PlayerDrawing& other = scene->players[0];
  const PlayerDrawing& own = scene->players[1];
  EXPECT_FALSE(other.own);
  EXPECT_TRUE(own.own);
  EXPECT_EQ(own.slot, match.slot(0));
  EXPECT_EQ(own.name, "someone");
  EXPECT_NE(own.pose.position, other.pose.position);  // the same run, seen a round trip apart
  EXPECT_EQ(scene->focus.position, own.pose.position);
}

// Of players that jump about: each is brighter for a moment after it has landed, and most of the time is not.
TEST(SceneFeed, WhoLandsFlashes) {
  LinkQuality line;
  line.delayMs = 60;
  line.jitterMs = 30;
  VirtualMatch match({endlessLevel()}, 1);
  match.join(line, pressing(1));
  match.join(line, pressing(2));
  match.run(seconds(3));
  SceneFeed feed;
  std::map<std::uint32_t, int> bright;
  constexpr int kFrames = 900;
  for (int frame = 0; frame < kFrames; ++frame) {
    match.run(milliseconds(16));
    const auto scene = feed.scene(match.session(0), match.now());
    ASSERT_TRUE(scene.has_value());
    for (const PlayerDrawing& player : scene->players)
      bright[player.slot] += player.colour != playerColour(player.slot);
  }
  for (const std::uint32_t slot : {0u, 1u}) {
    EXPECT_GT(bright[slot], 10) << slot;
    EXPECT_LT(bright[slot], kFrames / 2) << slot;
  }
}

TEST(SceneFeed, TakesTheStageOfTheNextLevel) {
  VirtualMatch match({flatLevel(), cornerLevel()}, 1);
  match.join(LinkQuality(), kRight);
  SceneFeed feed;
  match.run(seconds(1));
  const auto first = feed.scene(match.session(0), match.now());
  match.run(milliseconds(100));
  const auto same = feed.scene(match.session(0), match.now());
  match.run(seconds(8));
  const auto next = feed.scene(match.session(0), match.now());
  ASSERT_TRUE(first && same && next);
  EXPECT_EQ(first->stage, same->stage);
  EXPECT_NE(first->stage, next->stage);
  EXPECT_NE(first->stage->goal.face, next->stage->goal.face);
}

}  // namespace
}  // namespace platon
