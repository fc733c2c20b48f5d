#include "client/play/match/match_play.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "client/files/level_cache.h"
#include "client/files/user_folders.h"
#include "client/hud/hud.h"
#include "client/net/lossy_relay.h"
#include "client/replay/run_store.h"
#include "client/scene/camera.h"
#include "protocol/program_error.h"
#include "server/admin/console.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/loopback_server.h"
#include "tests/support/temporary_folder.h"

namespace platon::match_play_test {
namespace {

using std::chrono::seconds;

/// A player behind a relay with simulated network conditions.
class MatchPlayTest : public testing::Test {
 protected:
  // Updates until `done`, at most for `timeout`. Returns whether it is done.
  template <class Done>
  bool updateUntil(Moment timeout, Done done) {
    const auto update = [this](Moment now) {
      relay_->pump(now);
      play_->update(now, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
      relay_->pump(now);
    };
    return server_.runUntil(timeout, update, done);
  }

  void connect(const LinkQuality& quality) {
    relay_.emplace(server_.address(), quality, 1);
    play_.emplace(ClientOptions(), relay_->address(), server_.clock().now());
  }

  // Whether the head-up display of the next picture has this line.
  bool isInPicture(const std::string& line) {
    const Moment now = server_.clock().now();
    const std::optional<Scene> scene = play_->scene(now);
    Camera camera;
    camera.set(scene->focus, scene->stage->mesh, 1280, 720);
    const Overlay hud = makeHud(*scene, camera, play_->hudStatus(now, false), font_);
    return std::any_of(hud.texts.begin(), hud.texts.end(),
                       [&](const Overlay::Text& text) { return text.content == line; });
  }

  const TemporaryFolder data_;
  const EnvironmentVariable dataHome_{"XDG_DATA_HOME", data_.path().string()};
  Font font_;
  LoopbackServer server_;
  std::optional<LossyRelay> relay_;
  std::optional<MatchPlay> play_;
};

TEST_F(MatchPlayTest, PlaysUnderDelayAndLeaves) {
  LinkQuality quality;
  quality.delayMs = 60;
  connect(quality);
  EXPECT_EQ(play_->message(), "Loading …") << "a server of this program";
  EXPECT_FALSE(play_->scene(server_.clock().now()).has_value());
  ASSERT_TRUE(updateUntil(seconds(10), [&] {
    return play_->client().session() != nullptr &&
           play_->client().session()->predictionStatistics().confirmedTicks > 30;
  })) << play_->message();
  EXPECT_EQ(play_->message(), "");
  EXPECT_TRUE(play_->scene(server_.clock().now()).has_value());
  EXPECT_GE(play_->client().session()->linkStatistics().rttMs, 120);
  ASSERT_EQ(server_.server().match().players(), 1u);
  relay_->setQuality(LinkQuality());
  const Clock clock{server_.clock().now, [this](Moment until) {
                      relay_->pump(server_.clock().now());
                      server_.clock().sleepUntil(until);
                      relay_->pump(until);
                    }};
  play_->leave(clock);
  EXPECT_TRUE(play_->client().closed());
  EXPECT_EQ(server_.server().match().players(), 0u);
}

TEST_F(MatchPlayTest, ATextOfTheConsoleIsInThePictureForEightSeconds) {
  BanStore bans;
  Console console(server_.server().match(), bans, {[] { return ""; }, {}, {}, {}, [](std::string_view) {}});
  const auto say = [&](const std::string& text) {
    EXPECT_EQ(console.execute("say " + text, UtcTime()), (ConsoleReply{true, "said to 1 player"}));
    const Moment saidAt = server_.clock().now();
    EXPECT_TRUE(updateUntil(seconds(1), [&] { return isInPicture(text); }));
    return saidAt;
  };
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return play_->scene(server_.clock().now()).has_value(); }));
  say("Restart at noon");
  EXPECT_EQ(play_->message(), "");
  updateUntil(seconds(5), [] { return false; });
  EXPECT_TRUE(isInPicture("Restart at noon"));
  const Moment second = say("Restart at one");
  EXPECT_FALSE(isInPicture("Restart at noon"));
  EXPECT_TRUE(updateUntil(seconds(10), [&] { return !isInPicture("Restart at one"); }));
  EXPECT_GE(server_.clock().now() - second, MatchPlay::kNoticeTime);
  EXPECT_LE(server_.clock().now() - second, MatchPlay::kNoticeTime + seconds(1));
  EXPECT_FALSE(isInPicture("Restart at noon"));
}

TEST_F(MatchPlayTest, WhatAPlayerSaysIsInThePictureUnlessTheSettingsHideIt) {
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return play_->scene(server_.clock().now()).has_value(); }));
  EXPECT_TRUE(play_->say({"wait for me", 0}, server_.clock().now()));
  const auto isShown = [&] {
    const std::vector<std::string> chat = play_->hudStatus(server_.clock().now(), false).chat;
    return !chat.empty() && chat.back().ends_with(": wait for me");
  };
  EXPECT_TRUE(updateUntil(seconds(2), isShown));
  Settings settings;
  settings.chat = false;
  play_->show(settings);
  EXPECT_FALSE(isShown());
}

TEST_F(MatchPlayTest, AVoteEndsTheRoundAndThePictureCountsDown) {
  connect(LinkQuality());
  const auto voter = [](ClientId client) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    return hello;
  };
  server_.server().match().receive(1'000'000, voter(1));  // another player, without a connection
  server_.server().match().receive(1'000'001, voter(2));
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return play_->scene(server_.clock().now()).has_value(); }));
  play_->toggleVote();
  EXPECT_TRUE(updateUntil(seconds(2), [&] { return isInPicture("✓ 1 of 3 wants the next level (V)"); }));
  server_.server().match().receive(1'000'000, Vote{server_.server().match().round(), true});
  const auto next = [&](int second) { return "Next level in " + std::to_string(second) + " s: HEXAHEDRON"; };
  for (int second = 5; second >= 1; --second) {
    EXPECT_TRUE(updateUntil(seconds(2), [&] { return isInPicture(next(second)); })) << second;
  }
  EXPECT_TRUE(updateUntil(seconds(2), [&] { return !isInPicture(next(1)); }));
}

TEST_F(MatchPlayTest, KeepsTheLevelsOfAServerForTheNextStart) {
  const TemporaryFolder folder;
  const EnvironmentVariable cache("XDG_CACHE_HOME", folder.path().string());
  relay_.emplace(server_.address(), LinkQuality(), 1);
  ClientOptions options;
  options.server = relay_->address();
  for (int start = 0; start < 2; ++start) {
    play_.emplace(options, relay_->address(), server_.clock().now());
    EXPECT_EQ(play_->message(), "connecting to " + relay_->address().text() + " …");
    EXPECT_TRUE(updateUntil(seconds(10), [&] { return play_->scene(server_.clock().now()).has_value(); }));
    const LevelCache levels(folder / "platon/levels", relay_->address());
    EXPECT_EQ(levels.newest(8), std::vector{endlessLevel()->hash});
  }
}

class RunsOfAMatch : public MatchPlayTest {
 protected:
  // Runs to the goal with these options. Returns whether a scene fulfils `done`.
  bool playUntil(const ClientOptions& options, const std::function<bool(MatchPlay&, const Scene&)>& done) {
    LoopbackServer server([](std::string_view) {}, "", flatLevel());
    clock_ = server.clock();
    MatchPlay play(options, server.address(), clock_.now(), rival_);
    const auto update = [&](Moment now) {
      play.update(now, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
    };
    return server.runUntil(seconds(20), update, [&] {
      const std::optional<Scene> scene = play.scene(server.clock().now());
      return scene && done(play, *scene);
    });
  }
  std::filesystem::path rival_;
  Clock clock_;  // of the server of this match
  std::optional<StoredRun> best() const { return RunStore(runsFolder()).best(*flatLevel()); }
};

TEST_F(RunsOfAMatch, TheBestOneIsKeptAndPlaysAlongUnlessTheSettingsHideIt) {
  EXPECT_TRUE(playUntil({}, [&](MatchPlay& play, const Scene& scene) {
    EXPECT_TRUE(scene.ghosts.empty());
    EXPECT_EQ(play.bestRun(), std::filesystem::path());
    return play.hudStatus(Moment(), false).run.isNewBest;
  }));
  ASSERT_TRUE(best());
  EXPECT_TRUE(playUntil({}, [&](MatchPlay& play, const Scene& scene) {
    if (scene.ghosts.empty()) return false;
    EXPECT_EQ(play.hudStatus(Moment(), false).run.best, double{1} * best()->ticks / kTicksPerSecond);
    EXPECT_EQ(play.bestRun(), best()->file);
    EXPECT_TRUE(play.hudStatus(Moment(), false).timer);
    return true;
  }));
  Settings hidden;
  hidden.timer = hidden.ghosts = false;
  EXPECT_TRUE(playUntil({}, [&](MatchPlay& play, const Scene& scene) {
    play.show(hidden);
    EXPECT_TRUE(scene.ghosts.empty());
    EXPECT_FALSE(play.hudStatus(Moment(), false).timer);
    return scene.over;
  }));
}

TEST_F(RunsOfAMatch, TheRivalPlaysAlongAlsoIfTheSettingsHideGhosts) {
  EXPECT_TRUE(
      playUntil({}, [](MatchPlay& play, const Scene&) { return play.hudStatus(Moment(), false).run.isNewBest; }));
  ASSERT_TRUE(best());
  rival_ = best()->file.parent_path().parent_path() / "Anna.recording";
  std::filesystem::rename(best()->file, rival_);
  Settings hidden;
  hidden.ghosts = false;
  EXPECT_TRUE(playUntil({}, [&](MatchPlay& play, const Scene& scene) {
    play.show(hidden);
    if (scene.ghosts.empty()) return false;
    EXPECT_EQ(scene.ghosts.size(), 1U);
    return true;
  }));
}

TEST_F(RunsOfAMatch, WhatCouldNotBeKeptIsReportedToWhoLeavesAtOnce) {
  std::filesystem::create_directories(runsFolder().parent_path());
  writeText(runsFolder(), "a file in place of the folder");
  testing::internal::CaptureStderr();
  EXPECT_TRUE(playUntil({}, [&](MatchPlay& play, const Scene&) {
    if (!play.hudStatus(Moment(), false).run.isNewBest) return false;
    play.leave(clock_);
    return true;
  }));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("the best run is not kept: "), std::string::npos) << said;
}

TEST_F(RunsOfAMatch, TheDemonstrationHasNone) {
  ClientOptions demo;
  demo.demo = true;
  EXPECT_TRUE(playUntil(demo, [](MatchPlay&, const Scene& scene) { return scene.over; }));
  EXPECT_FALSE(best());
}

TEST_F(MatchPlayTest, DoesNotJoinUnderFullLoss) {
  LinkQuality quality;
  quality.lossPercent = 100;
  connect(quality);
  EXPECT_FALSE(updateUntil(seconds(1), [&] { return play_->client().session() != nullptr; }));
  EXPECT_EQ(server_.server().match().players(), 0u);
}

TEST_F(MatchPlayTest, ReportsWhyTheMatchEnded) {
  ClientOptions options;
  MatchPlay play(options, {"127.0.0.1", 1}, Moment{});
  for (Moment now{}; now <= seconds(6); now += std::chrono::milliseconds(50)) {
    play.update(now, [](const Game&, std::uint32_t) { return Input{}; });
  }
  EXPECT_EQ(play.message(), "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?");
}

TEST_F(MatchPlayTest, ThrowsForAnUnknownHost) {
  try {
    const MatchPlay play(ClientOptions(), {"no such host", 1}, server_.clock().now());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "cannot resolve host no such host");
  }
}

TEST_F(MatchPlayTest, JoinsNoServerWhileAKnownKeyIsDamaged) {
  const TemporaryFolder folder;
  const EnvironmentVariable data("XDG_DATA_HOME", folder.path().string());
  std::filesystem::create_directory(folder / "platon");
  writeText(folder / "platon/known_servers", server_.address().text() + " cut\n");
  ClientOptions options;
  options.server = server_.address();
  try {
    const MatchPlay play(options, server_.address(), server_.clock().now());
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with((folder / "platon/known_servers").string() + ":1: error: "));
  }
}

// Each was a line: 50 KB a second.
TEST_F(MatchPlayTest, AServerThatSaysSomethingInEveryFrameFillsNoDisk) {
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return play_->scene(server_.clock().now()).has_value(); }));
  testing::internal::CaptureStderr();
  for (int i = 0; i < 40; ++i) {
    const std::string text = "number " + std::to_string(i);
    server_.server().match().say(text);
    EXPECT_TRUE(updateUntil(seconds(1), [&] { return isInPicture(text); }));
  }
  play_->leave(server_.clock());
  const std::string written = testing::internal::GetCapturedStderr();
  const auto lines = std::count(written.begin(), written.end(), '\n');
  EXPECT_GE(lines, 11);
  EXPECT_LE(lines, 20);
  EXPECT_NE(written.find(" lines about the server left out: it causes too many\n"), std::string::npos) << written;
}

}  // namespace
}  // namespace platon::match_play_test
