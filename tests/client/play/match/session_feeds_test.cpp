#include "client/play/match/session_feeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::session_feeds_test {
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
  Session session("x", Time(0), memory);
  session.receive(encode(Welcome{0, 1, level, 4, kTicksPerSecond, ""}), Time(0));
  SceneFeed feed;
  EXPECT_FALSE(feed.scene(session, Time(0))->over);
  EXPECT_TRUE(feed.scene(session, Time(0))->timed);
  EXPECT_FALSE(feed.scene(session, Time(0), {.timed = false})->timed);
  session.receive(encode(RoundEnd{1, 0, level}), Time(0));
  EXPECT_TRUE(feed.scene(session, Time(0))->over);
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

constexpr double kFrame = 1.0 / 60;

// On OpenAL's loopback device, which needs no sound card.
class SoundFeedTest : public testing::Test {
 protected:
  void SetUp() override {
    settings_.musicVolume = 0;
    ASSERT_TRUE(waitUntil([this] {
      feed_.update(nullptr, nullptr, std::nullopt, settings_, 0);
      return feed_.audio().output() != nullptr;
    }));
  }

  // The loudest sample of the next frame.
  double hear() {
    double loudest = 0;
    for (const float sample : feed_.audio().output()->render(kSampleRate / 60)) {
      loudest = std::max(loudest, double{std::abs(sample)});
    }
    return loudest;
  }

  Settings settings_;
  SoundFeed feed_{&OpenalOutput::openLoopback};
};

TEST_F(SoundFeedTest, WithoutASessionNothingIsHeard) {
  feed_.update(nullptr, nullptr, std::nullopt, settings_, kFrame);
  EXPECT_EQ(hear(), 0);
}

TEST_F(SoundFeedTest, WhatTheMenuDoesIsHeard) {
  feed_.menu(Menu::Feedback::kNone);
  EXPECT_EQ(hear(), 0);
  feed_.menu(Menu::Feedback::kMoved);
  EXPECT_GT(hear(), 0.01);
}

TEST_F(SoundFeedTest, AChosenItemIsHeard) {
  feed_.menu(Menu::Feedback::kChosen);
  EXPECT_GT(hear(), 0.01);
}

TEST_F(SoundFeedTest, ARunningPlayerIsHeardUnlessTheVolumeIsZero) {
  SessionNetwork match({endlessLevel()}, 1);
  match.join({}, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
  match.run(std::chrono::seconds(1));
  SceneFeed scenes;
  double loudest = 0;
  for (int frame = 0; frame < 120; ++frame) {
    if (frame == 60) settings_.effectsVolume = loudest = 0;
    match.run(std::chrono::microseconds(16'667));
    const std::optional<Scene> scene = scenes.scene(match.session(0), match.now());
    feed_.update(&match.session(0), &scene.value(), std::nullopt, settings_, kFrame);
    const double heard = hear();
    if (frame >= 65) loudest = std::max(loudest, heard);
    if (frame == 59) {
      EXPECT_GT(heard, 0.002);
    }
  }
  EXPECT_LT(loudest, 1e-6);
}

}  // namespace
}  // namespace platon::session_feeds_test
