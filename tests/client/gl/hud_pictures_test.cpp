// A golden picture for each state of the head-up display, on a plain ground.

#include <cmath>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/hud/hud.h"
#include "client/ui/overlay.h"
#include "client/ui/replay_bar.h"
#include "tests/client/gl/flat_picture.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"

namespace platon::hud_pictures_test {
namespace {

constexpr const char* kNames[] = {"Ann", "Benedikt", "Лев", "Zoë", "D", "A very long name of a player"};

class HudPicturesTest : public testing::Test {
 protected:
  HudPicturesTest() {
    const LevelResult result =
        loadLevel("# title: Running start\nHEXAHEDRON\n0 0 0 0\n2 60 80\n480\n%\n%\n%\n%\n%\n%\n");
    scene_.stage = makeStageModel(*result.level);
    scene_.focus = scene_.stage->mesh.pose(0, {0, 0}, 0);
    scene_.secondsLeft = 83;
    status_.keys = KeyHints(Bindings(), false);
    setPlayers(4);
  }

  // The last one is the local one.
  void setPlayers(std::uint32_t count) {
    scene_.players.clear();
    for (std::uint32_t slot = 0; slot < count; ++slot) {
      const glm::dvec2 place(-220.0 + 90 * (slot % 6), 40.0 * (slot % 3) - 60);
      scene_.players.push_back(playerAt(*scene_.stage, slot, slot == 1 ? 3 : 0, place));
      scene_.players.back().name = slot < std::size(kNames) ? kNames[slot] : "";
    }
    scene_.players.back().local = true;
    scene_.attempt = AttemptDrawing{12.34, false};
  }
  void setAlone() {
    setPlayers(1);
    scene_.timed = false;
  }
  void arrive() {
    scene_.attempt = AttemptDrawing{10.96, true};
    scene_.players.back().finishSeconds = 10.96;
  }

  void expectHud(const std::string& name, std::uint32_t width = 960, std::uint32_t height = 540) {
    Camera camera;
    camera.set(scene_.focus, scene_.stage->mesh, width, height);
    status_.scale = textScale(1, height);
    expectOverlay(makeHud(scene_, camera, status_, font_), name, width, height);
  }
  void expectOverlay(const Overlay& overlay, const std::string& name, std::uint32_t width = 960,
                     std::uint32_t height = 540) {
    expectGolden(flatPicture(width, height, font_, std::span(&overlay, 1)), "hud/" + name);
  }

  const Offscreen context_;
  const Font font_;
  Scene scene_;
  HudStatus status_;
  NetGraph graph_;
};

TEST_F(HudPicturesTest, TimerAndSplits) {
  setAlone();
  status_.run = {.best = 11.48, .difference = -0.32, .isNewBest = false};
  expectHud("timer");
  status_.run.difference = 1.07;
  expectHud("timer_640x360", 640, 360);
}

TEST_F(HudPicturesTest, TheGoalAlone) {
  setAlone();
  arrive();
  status_.run = {.best = 10.96, .difference = -0.52, .isNewBest = true};
  status_.summary = RoundSummary{.nextTitle = "Thorns above", .bestSeconds = 10.96, .bestName = "Ann", .waits = true};
  status_.medals = MedalTimes{612, 800, 1200};
  expectHud("goal");
}

TEST_F(HudPicturesTest, PlayersAndSigns) {
  scene_.players[0].finishSeconds = 9.5;
  scene_.players[2].pose.position += 3000.0 * scene_.players[2].pose.up;
  expectHud("players");
}

TEST_F(HudPicturesTest, ManyPlayers) {
  setPlayers(64);
  for (std::size_t slot = 0; slot < 40; slot += 3)
    scene_.players[slot].finishSeconds = 100.0 + static_cast<double>(slot);
  scene_.secondsLeft = 7.25;
  expectHud("many_players");
  expectHud("many_players_640x360", 640, 360);
}

TEST_F(HudPicturesTest, Results) {
  setPlayers(6);
  arrive();
  scene_.players[0].finishSeconds = 9.5;
  scene_.secondsLeft = 0;
  status_.summary = RoundSummary{"Thorns above", 4.2, 9.5, "Ann", true};
  expectHud("results");
}

TEST_F(HudPicturesTest, VoteChatAndNotice) {
  status_.vote = VoteStatus{1, 4, true};
  status_.chat = {"Ann: wait for me", "Лев: I stand on the plate, run through the door as soon as it opens", "Zoë: ♥"};
  status_.notice = "The server restarts at noon";
  scene_.players[2].says = "Hello!";
  expectHud("vote_and_chat");
}

TEST_F(HudPicturesTest, ConnectionLost) {
  status_.message = "lost the connection to play.example.org:7777; reconnecting …";
  status_.warning = true;
  expectHud("connection_lost");
}

TEST_F(HudPicturesTest, Hints) {
  setAlone();
  status_.hint = "A D: roll";
  expectHud("hint");
  status_.hint = "watching Benedikt · E: next";
  setPlayers(4);
  expectHud("spectating");
  status_.hint.clear();
  scene_.needsRestart = true;
  scene_.neededPlayers = 2;
  expectHud("needs_restart");
}

TEST_F(HudPicturesTest, HelpAndGraph) {
  for (int i = 0; i < static_cast<int>(NetGraph::kSamples); ++i) {
    NetSample sample;
    sample.link = {
        .rttMs = 48 + 30 * std::abs(std::sin(i * 0.2)), .jitterMs = 4, .slackTicks = 2, .lostDownPercent = 1};
    sample.correctionSubunits = i % 50 == 0 ? 900 : 0;
    sample.corrections = 12;
    sample.lastCorrection = 900;
    sample.aheadTicks = 6;
    sample.downBytesPerSecond = 1900;
    sample.upBytesPerSecond = 1200;
    sample.framesPerSecond = 60;
    graph_.add(sample);
  }
  status_.netGraph = &graph_;
  expectHud("graph");
  expectHud("graph_640x360", 640, 360);
  status_.netGraph = nullptr;
  status_.help = true;
  expectHud("help");
  expectHud("help_640x360", 640, 360);
}

TEST_F(HudPicturesTest, HighContrast) {
  Camera camera;
  camera.set(scene_.focus, scene_.stage->mesh, 960, 540);
  Overlay hud = makeHud(scene_, camera, status_, font_);
  raiseContrast(hud);
  expectOverlay(hud, "high_contrast");
}

TEST_F(HudPicturesTest, WithoutAGame) {
  status_.message = "connecting to play.example.org:7777 …";
  expectOverlay(makeEmptyHud(status_, font_, Overlay::widthFor(960, 540)), "connecting");
}

TEST_F(HudPicturesTest, Replay) {
  expectOverlay(makeReplayBar({2000, 7200, 0.5, false, false, true}, font_, {1280, 720}), "replay");
  const float scale = textScale(1, 360);
  const Overlay bar = makeReplayBar({2000, 7200, 1, true, false, true}, font_, glm::vec2(1280, 720) / scale);
  expectOverlay(scaledBy(bar, scale), "replay_640x360", 640, 360);
}

}  // namespace
}  // namespace platon::hud_pictures_test
