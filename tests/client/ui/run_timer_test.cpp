#include "client/ui/run_timer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace platon::run_timer_test {
namespace {

Scene sceneOf(double seconds, bool arrived) {
  Scene scene;
  PlayerDrawing player;
  player.local = true;
  scene.players.push_back(player);
  scene.attempt = AttemptDrawing{seconds, arrived};
  return scene;
}

std::vector<std::string> textsOf(const Scene& scene, const RunStatus& run) {
  const Font font;
  OverlayWriter writer(font);
  addRunTimer(writer, scene, run, {16, 90});
  std::vector<std::string> texts;
  for (const Overlay::Text& text : writer.take().texts) texts.push_back(text.content);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(RunTimer, ADifferenceHasItsSignAndHundredths) {
  EXPECT_EQ(differenceText(0.316), "+0.32");
  EXPECT_EQ(differenceText(-1.05), "−1.05");
  EXPECT_EQ(differenceText(0.001), "±0.00");
  EXPECT_EQ(differenceText(-0.001), "±0.00");
  EXPECT_EQ(differenceText(61.5), "+61.50");
}

TEST(RunTimer, ShowsTheOwnTimeAndThePersonalBest) {
  EXPECT_EQ(textsOf(sceneOf(3, false), {}), Texts{"your time 3.00 s"});
  EXPECT_EQ(textsOf(sceneOf(3, false), {.best = 2.5}), (Texts{"your time 3.00 s", "personal best 2.50 s"}));
  EXPECT_EQ(textsOf(sceneOf(3, true), {.best = 2.5}), (Texts{"✓ Goal in 3.00 s", "personal best 2.50 s"}));
  EXPECT_EQ(textsOf(sceneOf(2, true), {.best = 2, .isNewBest = true}),
            (Texts{"✓ Goal in 2.00 s", "new personal best"}));
}

TEST(RunTimer, ATimeHasAMedalAtTheGoal) {
  const MedalTimes times{60, 120, 180};
  EXPECT_EQ(ownMedalText(sceneOf(1.5, true), times), "★★☆ silver, gold: 1.00 s");
  EXPECT_EQ(ownMedalText(sceneOf(1.5, false), times), "");
  EXPECT_EQ(ownMedalText(sceneOf(1.5, true), std::nullopt), "");
  EXPECT_EQ(ownMedalText(Scene(), times), "") << "no local player";
}

TEST(RunTimer, ShowsTheDifferenceBesideIt) {
  EXPECT_EQ(textsOf(sceneOf(3, false), {.best = 2.5, .difference = 0.25}),
            (Texts{"your time 3.00 s", "+0.25", "personal best 2.50 s"}));
}

TEST(RunTimer, WithoutABestRunTheBestOfTheRoundIsShown) {
  Scene scene = sceneOf(3, false);
  scene.players.back().finishSeconds = 4;
  EXPECT_EQ(textsOf(scene, {}), (Texts{"your time 3.00 s", "best 4.00 s"}));
  scene.attempt = AttemptDrawing{4, true};
  EXPECT_EQ(textsOf(scene, {}), Texts{"✓ Goal in 4.00 s"});
}

TEST(RunTimer, WithoutATimeLimitTheOwnTimeIsTheClock) {
  Scene scene = sceneOf(3, false);
  scene.timed = false;
  EXPECT_EQ(textsOf(scene, {}), Texts{"3.00 s"});
  EXPECT_EQ(textsOf(scene, {.best = 2.5, .difference = 0.25}), (Texts{"3.00 s", "+0.25", "personal best 2.50 s"}));
  scene.attempt->arrived = true;
  EXPECT_EQ(textsOf(scene, {.best = 3, .isNewBest = true}), (Texts{"✓ Goal in 3.00 s", "new personal best"}));
}

TEST(RunTimer, TellsAtTheGoalWhyTheRunIsNotKept) {
  EXPECT_EQ(textsOf(sceneOf(3, true), {.best = 2.5, .speed = 0.5}),
            (Texts{"✓ Goal in 3.00 s", "at 50 % speed, not kept"}));
  EXPECT_EQ(textsOf(sceneOf(3, true), {.notRecorded = "too long to be recorded"}),
            (Texts{"✓ Goal in 3.00 s", "too long to be recorded"}));
}

TEST(RunTimer, WithoutALocalPlayerThereIsNone) { EXPECT_EQ(textsOf(Scene(), {.best = 1}), Texts{}); }

}  // namespace
}  // namespace platon::run_timer_test
