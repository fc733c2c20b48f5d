#include "client/play/match/scene_feed.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/pressing.h"
#include "tests/support/session_network.h"
#include "tests/support/test_level.h"

namespace platon::scene_feed_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };

TEST(SceneFeed, ShowsTheLocalPlayerPredictedAndTheOthersInterpolated) {
  LinkQuality quality;
  quality.delayMs = 100;
  SessionNetwork match({endlessLevel()}, 1);
  match.join(quality, kRight);
  match.join(quality, kRight);
  SceneFeed feed;
  EXPECT_FALSE(feed.scene(match.session(0), match.now()).has_value());
  match.run(milliseconds(1500));
  const auto scene = feed.scene(match.session(0), match.now());
  ASSERT_TRUE(scene.has_value());
  ASSERT_EQ(scene->players.size(), 2u);
  const PlayerDrawing& other = scene->players[0];
  const PlayerDrawing& local = scene->players[1];
  EXPECT_FALSE(other.local);
  EXPECT_TRUE(local.local);
  EXPECT_EQ(local.slot, match.slot(0));
  EXPECT_EQ(local.name, "someone");
  EXPECT_NE(local.pose.position, other.pose.position);  // both run alike, but are drawn at different ticks
  EXPECT_EQ(scene->focus.position, local.pose.position);
}

TEST(SceneFeed, ShowsThatTheServerHasEndedTheRound) {
  Session::Memory memory;
  memory.levels = {endlessLevel()};
  const std::uint64_t level = endlessLevel()->hash;
  Session session("x", Moment(0), memory);
  session.receive(encode(Welcome{0, 1, level, 4, kTicksPerSecond, ""}), Moment(0));
  SceneFeed feed;
  EXPECT_FALSE(feed.scene(session, Moment(0))->over);
  EXPECT_TRUE(feed.scene(session, Moment(0))->timed);
  feed.setTimed(false);
  EXPECT_FALSE(feed.scene(session, Moment(0))->timed);
  session.receive(encode(RoundEnd{1, 0, level}), Moment(0));
  EXPECT_TRUE(feed.scene(session, Moment(0))->over);
}

TEST(SceneFeed, ShowsThatPlayersAreMissing) {
  const std::string level = "# players: 2\nHEXAHEDRON\n0 0 0 0\n2 0 0\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n";
  SessionNetwork match({loadLevel(level).level}, 1);
  match.join({}, kRight);
  match.run(milliseconds(500));
  EXPECT_EQ(SceneFeed().scene(match.session(0), match.now())->neededPlayers, 2U);
}

TEST(SceneFeed, ShowsTheRoundTripsThatTheServerTells) {
  const auto roundTrip = [](ClientId client) { return std::uint32_t{20 * client}; };
  SessionNetwork match({endlessLevel()}, 1, 16, {.roundTrip = roundTrip});
  match.join({}, kRight);
  match.join({}, kRight);
  SceneFeed feed;
  match.run(milliseconds(3000));
  const auto scene = feed.scene(match.session(0), match.now());
  ASSERT_TRUE(scene.has_value());
  ASSERT_EQ(scene->players.size(), 2u);
  EXPECT_EQ(scene->players[0].roundTripMs, 40u);
  EXPECT_EQ(scene->players[1].roundTripMs, 20u);
}

// Jumping players are brighter for a short time after each landing.
TEST(SceneFeed, LandingPlayersFlash) {
  LinkQuality quality;
  quality.delayMs = 60;
  quality.jitterMs = 30;
  SessionNetwork match({endlessLevel()}, 1);
  match.join(quality, pressing(1));
  match.join(quality, pressing(2));
  match.run(seconds(3));
  SceneFeed feed;
  std::map<std::uint32_t, int> bright;
  constexpr int kFrames = 900;
  for (int frame = 0; frame < kFrames; ++frame) {
    match.run(milliseconds(16));
    const auto scene = feed.scene(match.session(0), match.now());
    ASSERT_TRUE(scene.has_value());
    for (const PlayerDrawing& player : scene->players) bright[player.slot] += player.flash > 0;
  }
  for (const std::uint32_t slot : {0u, 1u}) {
    EXPECT_GT(bright[slot], 10) << slot;
    EXPECT_LT(bright[slot], kFrames / 2) << slot;
  }
}

TEST(SceneFeed, TheOwnTimeRunsWithThePredictedGame) {
  SessionNetwork match({endlessLevel()}, 1);
  match.join(LinkQuality(), kRight);
  match.run(seconds(2));
  SceneFeed feed;
  const auto first = feed.scene(match.session(0), match.now());
  match.run(seconds(1));
  const auto second = feed.scene(match.session(0), match.now());
  ASSERT_TRUE(first && first->attempt && second && second->attempt);
  EXPECT_GT(first->attempt->seconds, 1);
  EXPECT_NEAR(second->attempt->seconds - first->attempt->seconds, 1, 0.1);
  EXPECT_FALSE(second->needsRestart);
}

TEST(SceneFeed, ChangesTheStageWithTheLevel) {
  SessionNetwork match({flatLevel(), cornerLevel()}, 1);
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
}  // namespace platon::scene_feed_test
