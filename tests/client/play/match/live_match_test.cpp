#include "client/play/match/live_match.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "client/files/server_files.h"
#include "client/files/user_folders.h"
#include "client/hud/hud.h"
#include "client/net/enet_link.h"
#include "client/net/network_conditions.h"
#include "client/replay/run_store.h"
#include "client/scene/camera.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "server/admin/console.h"
#include "server/app/dedicated_server.h"
#include "server/app/level_files.h"
#include "tests/client/play/match/on_loopback.h"
#include "tests/net/support/loopback_server.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::live_match_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* kLevel = "tests/determinism/golden/levels/hexahedron.level";

// The same for a tick of the same number.
Input inputOf(std::uint32_t tick) { return Input{tick / 20 % 2 == 0 ? Input::kRight : Input::kLeft}; }

class LiveMatchTest : public testing::Test {
 protected:
  static MatchChoice ownLevel() {
    MatchChoice choice;
    choice.own.levels = {kLevel};
    return choice;
  }
  // Others on this machine can join it.
  static MatchChoice openLevel() {
    MatchChoice choice;
    choice.own = onLoopback({kLevel});
    return choice;
  }

  bool updateUntil(LiveMatch& match, bool wantsPause, const std::function<bool()>& done, double speed = 1) {
    const Controls controls = [](const Game& game, std::uint32_t) { return inputOf(game.tick()); };
    const Time end = clock_.now() + seconds(60);
    for (Time now = clock_.now(); now < end; now = clock_.now()) {
      match.update(wantsPause, controls, speed);
      if (done()) return true;
      clock_.sleepUntil(now + milliseconds(2));
    }
    return false;
  }

  // Lets a match pause for 7 s, of which less than one is real.
  void passLongerThanEveryTimeout(LiveMatch& match) {
    int frames = 0;
    stepUntil(
        [&] {
          skipped_ += milliseconds(20) / Time(1);
          match.update(true, [](const Game&, std::uint32_t) { return Input{}; });
        },
        [&] { return ++frames == 350; });
  }

  static const Prediction* prediction(const LiveMatch& match) {
    const Session* const session = match.client().session();
    return session && session->round() ? &session->round()->prediction() : nullptr;
  }
  static std::uint32_t confirmed(const LiveMatch& match) {
    return prediction(match) ? prediction(match)->confirmedTicks() : 0;
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", (folder_ / "cache").string()};
  std::atomic<Time::rep> skipped_ = 0;
  // Real time, and what was skipped.
  const Clock clock_{[this] { return steadyClock().now() + Time(skipped_); },
                     [this](Time until) { steadyClock().sleepUntil(until - Time(skipped_)); }};
};

TEST_F(LiveMatchTest, NoTickPassesWhileAPlayerWhoIsAlonePauses) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  EXPECT_EQ(match.message(), "Loading …");
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 30 && match.alone(); }));
  ASSERT_TRUE(updateUntil(match, true, [&] { return match.paused(); }));
  passLongerThanEveryTimeout(match);  // until nothing is on the way any more
  const std::uint32_t before = confirmed(match);
  const std::uint32_t predicted = prediction(match)->predictedTicks();
  passLongerThanEveryTimeout(match);
  EXPECT_EQ(confirmed(match), before);
  EXPECT_EQ(prediction(match)->predictedTicks(), predicted);
  EXPECT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > before + 30; }));
  EXPECT_EQ(match.message(), "");
  match.leave();
}

TEST_F(LiveMatchTest, WithAnotherPlayerTheGameGoesOn) {
  LiveMatch match(ClientOptions(), openLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10; }));
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  ASSERT_TRUE(updateUntil(match, true, [&] {
    other.update(true, [](const Game&, std::uint32_t) { return Input{}; });
    return confirmed(other) > 10;
  }));
  EXPECT_FALSE(match.alone());
  EXPECT_FALSE(match.paused());
  EXPECT_FALSE(other.paused());
  other.leave();
  EXPECT_TRUE(updateUntil(match, true, [&] { return match.paused(); }));
  match.leave();
}

TEST_F(LiveMatchTest, ThePlayerHasTheNameOfTheChoiceUnlessTheOptionsNameOne) {
  for (const std::string& option : {std::string(), std::string("Ben")}) {
    ClientOptions options;
    options.name = option;
    MatchChoice choice = ownLevel();
    choice.name = "Ann";
    LiveMatch match(options, choice, clock_);
    ASSERT_TRUE(
        updateUntil(match, false, [&] { return confirmed(match) > 0 && !match.client().session()->names().empty(); }));
    EXPECT_EQ(match.client().session()->names().front(), option.empty() ? "Ann" : "Ben");
    match.leave();
  }
}

TEST_F(LiveMatchTest, ARoundOfAPlayerWhoIsAloneHasNoTimeLimit) {
  MatchChoice choice = openLevel();
  choice.own.waitsForOne = true;
  LiveMatch match(ClientOptions(), choice, clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.waits(); }));
  match.update(false, [](const Game&, std::uint32_t) { return Input{}; });
  EXPECT_FALSE(match.scene()->timed);
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] {
    other.update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return confirmed(other) > 10 && !match.alone();
  }));
  EXPECT_FALSE(match.waits());
  match.update(false, [](const Game&, std::uint32_t) { return Input{}; });
  EXPECT_TRUE(match.scene()->timed);
  EXPECT_TRUE(other.scene()->timed);
  other.leave();
  match.leave();
}

TEST_F(LiveMatchTest, AskingTwiceForTheNextLevelSkipsNone) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.alone(); }));
  const auto round = [&] { return match.client().session()->round()->id(); };
  const std::uint32_t first = round();
  match.skipLevel();
  ASSERT_TRUE(updateUntil(match, false, [&] {
    if (round() == first) match.skipLevel();
    return round() != first && confirmed(match) > 10;
  }));
  EXPECT_EQ(round(), first + 1);
  match.leave();
}

TEST_F(LiveMatchTest, RunsSlowerForWhoIsAloneOnly) {
  LiveMatch match(ClientOptions(), openLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.alone(); }));
  EXPECT_EQ(match.leastSpeed(), 1);
  ASSERT_TRUE(updateUntil(
      match, false, [&] { return match.leastSpeed() == 0.5; }, 0.5));
  const Time real = clock_.now();
  const Time own = match.now();
  ASSERT_TRUE(updateUntil(
      match, false, [&] { return match.now() - own > milliseconds(100); }, 0.5));
  EXPECT_GE(clock_.now() - real, milliseconds(200));
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 30; }));
  EXPECT_EQ(match.leastSpeed(), 0.5) << "of this attempt";
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  const auto othersPlay = [&] {
    other.update(
        false, [](const Game&, std::uint32_t) { return Input{}; }, 0.5);
    return confirmed(other) > 10 && !match.alone();
  };
  ASSERT_TRUE(updateUntil(match, false, othersPlay, 0.5));
  EXPECT_EQ(other.leastSpeed(), 1);
  const Time time = match.now();
  const Time before = clock_.now();
  updateUntil(
      match, false, [&] { return clock_.now() - before > milliseconds(50); }, 0.5);
  EXPECT_GE(match.now() - time, milliseconds(50)) << "not slowed with others";
  other.leave();
  match.leave();
}

// A floor on which a player that runs to the right reaches the goal within two seconds.
constexpr const char* kShortWay =
    "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";

TEST_F(LiveMatchTest, AGoalReachedAtHalfSpeedIsRememberedWithoutATime) {
  const std::string file = folder_ / "short.level";
  writeText(file, kShortWay);
  MatchChoice choice;
  choice.own.levels = {file};
  choice.own.waitsForOne = true;
  LiveMatch match(ClientOptions(), choice, clock_);
  double speed = 0.5;
  const auto run = [&](Input input, const std::function<bool()>& done) {
    return waitUntil([&] {
      match.update(
          false, [&](const Game&, std::uint32_t) { return input; }, speed);
      return done();
    });
  };
  const auto arrived = [&] {
    const Prediction* const known = prediction(match);
    return known && known->confirmed().slots() > 0 && known->confirmed().player(0).arrived != 0;
  };
  ASSERT_TRUE(run(Input{Input::kRight}, arrived));
  EXPECT_EQ(match.leastSpeed(), 0.5);
  EXPECT_TRUE(ReachedLevels(reachedLevelsFile()).has(match.level()->hash));
  EXPECT_FALSE(match.hudStatus().run.isNewBest);
  speed = 1;
  ASSERT_TRUE(run(Input{Input::kRestart}, [&] { return !arrived(); }));
  ASSERT_TRUE(run(Input{Input::kRight}, arrived));
  EXPECT_EQ(match.leastSpeed(), 1) << "an attempt begun at full speed counts";
  EXPECT_TRUE(match.hudStatus().run.isNewBest);
  match.leave();
}

TEST_F(LiveMatchTest, WhoIsAlonePlaysTheLevelAnewWhenItsFileChanges) {
  const std::string file = folder_ / "mine.level";
  const std::string room = kShortWay;
  writeText(file, "# title: first\n" + room);
  MatchChoice choice;
  choice.own.levels = {file};
  LiveMatch match(ClientOptions(), choice, clock_);
  const auto plays = [&](const std::string& title) { return match.level() && match.level()->title == title; };
  ASSERT_TRUE(updateUntil(match, false, [&] { return plays("first"); }));
  writeText(file, "# title: broken\nCUBE\n");
  ASSERT_TRUE(updateUntil(match, false, [&] { return !match.hudStatus().notice.empty(); }));
  EXPECT_TRUE(plays("first"));
  EXPECT_TRUE(match.hudStatus().notice.starts_with("level not reloaded: 2:1: error: ")) << match.hudStatus().notice;
  writeText(file, "# title: second\n" + room);
  EXPECT_TRUE(updateUntil(match, false, [&] { return plays("second"); }));
  match.leave();
}

TEST_F(LiveMatchTest, OnlyAServerThatListensHasAnInvitation) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  EXPECT_TRUE(match.invitation().empty());
  MatchChoice hosted = openLevel();
  hosted.own.password = "secret";
  LiveMatch open(ClientOptions(), hosted, clock_);
  ASSERT_EQ(open.invitation().size(), 1U);
  EXPECT_TRUE(updateUntil(open, false, [&] { return confirmed(open) > 10; })) << "its own player knows the password";
  open.leave();
}

/// A player behind a relay with simulated network conditions.
class JoinedMatchTest : public testing::Test {
 protected:
  // Updates until `done`, at most for `timeout`. Returns whether it is done.
  template <class Done>
  bool updateUntil(Time timeout, Done done) {
    const auto update = [this](Time now) {
      relay_->pump(now);
      match_->update(false, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
      relay_->pump(now);
    };
    return server_.runUntil(timeout, update, done);
  }

  void connect(const LinkQuality& quality) {
    relay_.emplace(server_.address(), quality, 1);
    match_.emplace(ClientOptions(), MatchChoice{.server = relay_->address()}, clock_);
  }

  // Whether the head-up display of the next picture has this line.
  bool isInPicture(const std::string& line) {
    const std::optional<Scene> scene = match_->scene();
    Camera camera;
    camera.set(scene->focus, scene->stage->mesh, 1280, 720);
    const Overlay hud = makeHud(*scene, camera, match_->hudStatus(), font_);
    return std::any_of(hud.texts.begin(), hud.texts.end(),
                       [&](const Overlay::Text& text) { return text.content == line; });
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", folder_.path().string()};
  Font font_;
  LoopbackServer server_;
  std::optional<LossyRelay> relay_;
  // That of the server; what is sent goes through the relay.
  const Clock clock_{server_.clock().now, [this](Time until) {
                       relay_->pump(server_.clock().now());
                       server_.clock().sleepUntil(until);
                       relay_->pump(until);
                     }};
  std::optional<LiveMatch> match_;
};

TEST_F(JoinedMatchTest, PlaysUnderDelayAndLeaves) {
  LinkQuality quality;
  quality.delayMs = 60;
  connect(quality);
  EXPECT_EQ(match_->message(), "connecting to " + relay_->address().text() + " …");
  EXPECT_FALSE(match_->scene().has_value());
  ASSERT_TRUE(updateUntil(seconds(10), [&] {
    return match_->client().session() != nullptr &&
           match_->client().session()->predictionStatistics().confirmedTicks > 30;
  })) << match_->message();
  EXPECT_EQ(match_->message(), "");
  EXPECT_TRUE(match_->scene().has_value());
  EXPECT_GE(match_->client().session()->linkStatistics().rttMs, 120);
  ASSERT_EQ(server_.server().match().players(), 1u);
  relay_->setQuality(LinkQuality());
  match_->leave();
  EXPECT_TRUE(match_->client().closed());
  EXPECT_EQ(server_.server().match().players(), 0u);
}

TEST_F(JoinedMatchTest, ATextOfTheConsoleIsInThePictureForEightSeconds) {
  BanStore bans;
  Console console(server_.server().match(), bans, {[] { return ""; }, {}, {}, {}, [](std::string_view) {}});
  const auto say = [&](const std::string& text) {
    EXPECT_EQ(console.execute("say " + text, UtcTime()), (ConsoleReply{true, "said to 1 player"}));
    const Time saidAt = server_.clock().now();
    EXPECT_TRUE(updateUntil(seconds(1), [&] { return isInPicture(text); }));
    return saidAt;
  };
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return match_->scene().has_value(); }));
  say("Restart at noon");
  EXPECT_EQ(match_->message(), "");
  updateUntil(seconds(5), [] { return false; });
  EXPECT_TRUE(isInPicture("Restart at noon"));
  const Time second = say("Restart at one");
  EXPECT_FALSE(isInPicture("Restart at noon"));
  EXPECT_TRUE(updateUntil(seconds(10), [&] { return !isInPicture("Restart at one"); }));
  EXPECT_GE(server_.clock().now() - second, LiveMatch::kNoticeTime);
  EXPECT_LE(server_.clock().now() - second, LiveMatch::kNoticeTime + seconds(1));
  EXPECT_FALSE(isInPicture("Restart at noon"));
}

TEST_F(JoinedMatchTest, WhatAPlayerSaysIsInThePictureUnlessTheSettingsHideIt) {
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return match_->scene().has_value(); }));
  EXPECT_TRUE(match_->say({"wait for me", 0}));
  Settings settings;
  const auto isShown = [&] {
    const std::vector<std::string> chat = match_->hudStatus(settings).chat;
    return !chat.empty() && chat.back().ends_with(": wait for me");
  };
  EXPECT_TRUE(updateUntil(seconds(2), isShown));
  EXPECT_EQ(match_->said(settings).size(), 1U);
  settings.chat = false;
  EXPECT_FALSE(isShown());
  EXPECT_TRUE(match_->said(settings).empty());
}

TEST_F(JoinedMatchTest, AVoteEndsTheRoundAndThePictureCountsDown) {
  connect(LinkQuality());
  const auto voter = [](ClientId client) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    return hello;
  };
  server_.server().match().receive(1'000'000, voter(1));  // another player, without a connection
  server_.server().match().receive(1'000'001, voter(2));
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return match_->scene().has_value(); }));
  match_->skipLevel();
  EXPECT_TRUE(updateUntil(seconds(2), [&] { return isInPicture("✓ 1 of 3 wants the next level (V)"); }));
  server_.server().match().receive(1'000'000, Vote{server_.server().match().round(), true});
  const auto next = [&](int second) { return "Next level in " + std::to_string(second) + " s: HEXAHEDRON"; };
  for (int second = 5; second >= 1; --second) {
    EXPECT_TRUE(updateUntil(seconds(2), [&] { return isInPicture(next(second)); })) << second;
  }
  EXPECT_TRUE(updateUntil(seconds(2), [&] { return !isInPicture(next(1)); }));
}

TEST_F(JoinedMatchTest, KeepsTheLevelsOfAServerForTheNextStart) {
  connect(LinkQuality());
  for (int start = 0; start < 2; ++start) {
    match_.emplace(ClientOptions(), MatchChoice{.server = relay_->address()}, clock_);
    EXPECT_TRUE(updateUntil(seconds(10), [&] { return match_->scene().has_value(); }));
    const LevelCache levels(folder_ / "platon/levels", relay_->address());
    EXPECT_EQ(levels.newest(8), std::vector{endlessLevel()->hash});
  }
}

class RunsOfAMatch : public LiveMatchTest {
 protected:
  // Runs to the goal with these options. Returns whether a scene fulfils `done`.
  bool playUntil(const ClientOptions& options, const std::function<bool(LiveMatch&, const Scene&)>& done) {
    const std::string file = folder_ / "flat.level";
    writeText(file, flatLevel()->text);
    MatchChoice choice;
    choice.own.levels = {file};
    choice.rival = rival_;
    LiveMatch match(options, choice, clock_);
    return waitUntil([&] {
      match.update(false, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
      const std::optional<Scene> scene = match.scene(settings_);
      return scene && done(match, *scene);
    });
  }
  std::filesystem::path rival_;
  Settings settings_;
  std::optional<StoredRun> best() const { return RunStore(runsFolder()).best(*flatLevel()); }
};

TEST_F(RunsOfAMatch, TheBestOneIsKeptAndPlaysAlongUnlessTheSettingsHideIt) {
  EXPECT_TRUE(playUntil({}, [&](LiveMatch& match, const Scene& scene) {
    EXPECT_TRUE(scene.ghosts.empty());
    EXPECT_EQ(match.bestRun(), std::filesystem::path());
    return match.hudStatus().run.isNewBest;
  }));
  ASSERT_TRUE(best());
  EXPECT_TRUE(playUntil({}, [&](LiveMatch& match, const Scene& scene) {
    if (scene.ghosts.empty()) return false;
    EXPECT_EQ(match.hudStatus().run.best, double{1} * best()->ticks / kTicksPerSecond);
    EXPECT_EQ(match.bestRun(), best()->file);
    EXPECT_TRUE(match.hudStatus().timer);
    return true;
  }));
  settings_.timer = settings_.ghosts = false;
  EXPECT_TRUE(playUntil({}, [&](LiveMatch& match, const Scene& scene) {
    EXPECT_TRUE(scene.ghosts.empty());
    EXPECT_FALSE(match.hudStatus(settings_).timer);
    return scene.over;
  }));
}

TEST_F(RunsOfAMatch, TheRivalPlaysAlongAlsoIfTheSettingsHideGhosts) {
  EXPECT_TRUE(playUntil({}, [](LiveMatch& match, const Scene&) { return match.hudStatus().run.isNewBest; }));
  ASSERT_TRUE(best());
  rival_ = best()->file.parent_path().parent_path() / "Anna.recording";
  std::filesystem::rename(best()->file, rival_);
  settings_.ghosts = false;
  EXPECT_TRUE(playUntil({}, [&](LiveMatch&, const Scene& scene) {
    if (scene.ghosts.empty()) return false;
    EXPECT_EQ(scene.ghosts.size(), 1U);
    return true;
  }));
}

TEST_F(RunsOfAMatch, WhatCouldNotBeKeptIsReportedToWhoLeavesAtOnce) {
  std::filesystem::create_directories(runsFolder().parent_path());
  writeText(runsFolder(), "a file in place of the folder");
  testing::internal::CaptureStderr();
  EXPECT_TRUE(playUntil({}, [&](LiveMatch& match, const Scene&) {
    if (!match.hudStatus().run.isNewBest) return false;
    match.leave();
    return true;
  }));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("cannot save the best run: "), std::string::npos) << said;
}

TEST_F(RunsOfAMatch, TheDemonstrationHasNone) {
  ClientOptions demo;
  demo.demo = true;
  EXPECT_TRUE(playUntil(demo, [](LiveMatch&, const Scene& scene) { return scene.over; }));
  EXPECT_FALSE(best());
}

// Before, it gave the user medals on levels whose goals only the program had reached.
TEST_F(RunsOfAMatch, TheDemonstrationLeavesNoBestTime) {
  ClientOptions demo;
  demo.demo = true;
  for (const ClientOptions& options : {demo, ClientOptions()}) {
    EXPECT_TRUE(playUntil(options, [&](LiveMatch& match, const Scene&) {
      const HudStatus status = match.hudStatus();
      if (!status.summary) return false;
      EXPECT_EQ(status.summary->bestSeconds.has_value(), !options.demo);
      EXPECT_FALSE(options.demo && status.run.isNewBest);
      return true;
    }));
    EXPECT_EQ(std::filesystem::exists(bestTimesFile()), !options.demo);
  }
}

TEST_F(JoinedMatchTest, DoesNotJoinUnderFullLoss) {
  LinkQuality quality;
  quality.lossPercent = 100;
  connect(quality);
  EXPECT_FALSE(updateUntil(seconds(1), [&] { return match_->client().session() != nullptr; }));
  EXPECT_EQ(server_.server().match().players(), 0u);
}

TEST_F(JoinedMatchTest, ReportsWhyTheMatchEnded) {
  Time now{};
  LiveMatch match(ClientOptions(), {.server = ServerAddress{"127.0.0.1", 1}}, {[&now] { return now; }, [](Time) {}});
  for (; now <= seconds(6); now += milliseconds(50)) {
    match.update(false, [](const Game&, std::uint32_t) { return Input{}; });
  }
  EXPECT_EQ(match.message(), "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?");
}

TEST_F(JoinedMatchTest, ThrowsForAnUnknownHost) {
  try {
    const LiveMatch match(ClientOptions(), {.server = ServerAddress{"no such host", 1}}, clock_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "cannot resolve host no such host");
  }
}

TEST_F(JoinedMatchTest, JoinsNoServerWhileAKnownKeyIsDamaged) {
  std::filesystem::create_directory(folder_ / "platon");
  writeText(folder_ / "platon/known_servers", server_.address().text() + " cut\n");
  try {
    const LiveMatch match(ClientOptions(), {.server = server_.address()}, clock_);
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with((folder_ / "platon/known_servers").string() + ":1: error: "));
  }
}

// Each was a line: 50 KB a second.
TEST_F(JoinedMatchTest, AServerThatSaysSomethingInEveryFrameFillsNoDisk) {
  connect(LinkQuality());
  ASSERT_TRUE(updateUntil(seconds(10), [&] { return match_->scene().has_value(); }));
  testing::internal::CaptureStderr();
  for (int i = 0; i < 40; ++i) {
    const std::string text = "number " + std::to_string(i);
    server_.server().match().say(text);
    EXPECT_TRUE(updateUntil(seconds(1), [&] { return isInPicture(text); }));
  }
  match_->leave();
  const std::string written = testing::internal::GetCapturedStderr();
  const auto lines = std::count(written.begin(), written.end(), '\n');
  EXPECT_GE(lines, 11);
  EXPECT_LE(lines, 20);
  EXPECT_NE(written.find(" lines about the server left out: there were too many\n"), std::string::npos) << written;
}

// Hashes of the confirmed game by tick, of a client and a server that go by one clock. With `pauses`, the clock stands
// still for 3 s after every 0.7 s. Time is virtual.
std::map<std::uint32_t, std::uint64_t> hashesOf(bool pauses, double speed = 1) {
  Time real = steadyClock().now();
  PausableClock clock([&real] { return real; });
  ServerSettings settings;
  settings.bind = "127.0.0.1";
  clock.setSpeed(speed);
  DedicatedServer server(settings, loadLevelFiles({kLevel}).levels, Log(LogFormat::kText, [](std::string_view) {}));
  NetworkClient client(enetLinks({"127.0.0.1", server.port()}), {"Ann"}, clock.now());
  std::map<std::uint32_t, std::uint64_t> hashes;
  for (int step = 0; hashes.empty() || hashes.rbegin()->first < 600; ++step) {
    clock.setPaused(pauses && step % 1850 >= 350);
    server.step(TimePoint(clock.now()));
    client.update(clock.now(), [](const Game& game, std::uint32_t) { return inputOf(game.tick()); });
    const Session* const session = client.session();
    if (session && session->round()) {
      const Prediction& prediction = session->round()->prediction();
      hashes.emplace(prediction.confirmedTicks(), prediction.confirmed().hash());
    }
    real += milliseconds(2);
  }
  return hashes;
}

TEST(PausedMatch, TheSameInputsAtHalfSpeedGiveTheSameHashes) { EXPECT_EQ(hashesOf(false, 0.5), hashesOf(false)); }

TEST(PausedMatch, TheSameInputsWithPausesGiveTheSameHashes) { EXPECT_EQ(hashesOf(true), hashesOf(false)); }

}  // namespace
}  // namespace platon::live_match_test
