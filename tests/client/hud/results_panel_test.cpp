#include "client/hud/results_panel.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace platon::results_panel_test {
namespace {

constexpr float kWidth = 1280;

const Font& font() {
  static const Font font;
  return font;
}

Scene sceneOf(int players) {
  Scene scene;
  for (int i = 0; i < players; ++i) {
    PlayerDrawing player;
    player.slot = static_cast<std::uint32_t>(i);
    player.number = std::to_string(i + 1);
    player.name = "Name" + player.number;
    scene.players.push_back(player);
  }
  return scene;
}

Overlay panelOf(const Scene& scene, const RoundSummary& summary, const RunStatus& run = {}) {
  OverlayWriter writer(font());
  addResults(writer, scene, summary, run, font(), kWidth, 8);
  return writer.take();
}

// The lines of text from top to bottom, and each from left to right.
std::vector<std::string> linesOf(const Overlay& panel) {
  std::vector<Overlay::Text> texts = panel.texts;
  std::sort(texts.begin(), texts.end(), [](const Overlay::Text& a, const Overlay::Text& b) {
    return a.place.y != b.place.y ? a.place.y < b.place.y : a.place.x < b.place.x;
  });
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0 && texts[i].place.y == texts[i - 1].place.y)
      lines.back() += " | " + texts[i].content;
    else
      lines.push_back(texts[i].content);
  }
  return lines;
}

TEST(ResultsPanel, NamesTheTimesInOrderTheBestAndWhatComesNext) {
  Scene scene = sceneOf(3);
  scene.players[2].finishSeconds = 12.34;
  scene.players[0].finishSeconds = 40;
  const RoundSummary summary{"Corners", 4.2, 11.5, "Cid", false};
  EXPECT_EQ(linesOf(panelOf(scene, summary)),
            (std::vector<std::string>{"Time is up", "1. | Name3 | 12.34 s", "2. | Name1 | 40.00 s", "Name2 | –",
                                      "Best time 11.50 s, Cid", "Next level in 5 s: Corners"}));
  scene.secondsLeft = 1;
  EXPECT_EQ(linesOf(panelOf(scene, summary)).front(), "Round over");
}

TEST(ResultsPanel, ATeamHasOneTimeAndNoRanks) {
  Scene scene = sceneOf(2);
  scene.isTeam = true;
  scene.players[1].finishSeconds = 12.34;
  scene.teamSeconds = 12.34;
  scene.attempt = {15, true};
  EXPECT_EQ(linesOf(panelOf(scene, {"Corners", 4.2, 11.5, "Cid", false})),
            (std::vector<std::string>{"Time is up", "Name2 | ✓", "Name1 | –", "Together: 12.34 s",
                                      "Best time 11.50 s, Cid", "Next level in 5 s: Corners"}));
  EXPECT_EQ(ownResultOf(scene, {}, std::nullopt).headline, "Together at the goal!");
  EXPECT_EQ(ownResultOf(scene, {}, std::nullopt).time, "12.34 s");
}

TEST(ResultsPanel, TellsTheKnownRoundTrips) {
  Scene scene = sceneOf(2);
  scene.players[0].finishSeconds = 7;
  scene.players[0].roundTripMs = 24;
  const std::vector<std::string> lines = linesOf(panelOf(scene, {"A", 1}));
  EXPECT_EQ(lines[1], "1. | Name1 | 7.00 s | 24 ms");
  EXPECT_EQ(lines[2], "Name2 | –");
}

TEST(ResultsPanel, SaysThatTheBestTimeIsNewOrThatThereIsNone) {
  EXPECT_EQ(linesOf(panelOf(sceneOf(0), {"A", 1, 7.0, "Ann", true}))[1], "New best time: Ann");
  EXPECT_EQ(linesOf(panelOf(sceneOf(0), {"A", 1}))[1], "Nobody has reached the goal yet");
}

TEST(ResultsPanel, CountsWholeSecondsDown) {
  const auto next = [](double seconds) { return linesOf(panelOf(sceneOf(1), {"A", seconds})).back(); };
  EXPECT_EQ(next(5), "Next level in 5 s: A");
  EXPECT_EQ(next(4.001), "Next level in 5 s: A");
  EXPECT_EQ(next(4), "Next level in 4 s: A");
  EXPECT_EQ(next(0.1), "Next level in 1 s: A");
  EXPECT_EQ(next(0), "Next level: A");
}

TEST(ResultsPanel, ManyPlayersAndLongTextsStayOnTheScreen) {
  Scene scene = sceneOf(256);
  for (PlayerDrawing& player : scene.players) {
    player.name = std::string(32, 'W');
    player.roundTripMs = 1016;
  }
  const Overlay panel = panelOf(scene, {std::string(100, 'W'), 5, 300.0, std::string(32, 'W'), true});
  const std::vector<std::string> lines = linesOf(panel);
  EXPECT_NE(std::find(lines.begin(), lines.end(), "and 248 more"), lines.end());
  for (const Overlay::Text& text : panel.texts) {
    EXPECT_GE(text.place.x, 0) << text.content;
    EXPECT_LE(text.place.x + font().width(text.content) * text.size, kWidth) << text.content;
    EXPECT_LT(text.place.y, Overlay::kHeight * 0.62F) << text.content;
  }
}

constexpr MedalTimes kMedals{.gold = 600, .silver = 900, .bronze = 1200};  // 10 s, 15 s and 20 s

// The lines of what a player who is alone has reached in this time.
std::vector<std::string> ownLines(double seconds, const RunStatus& run,
                                  const std::optional<MedalTimes>& medals = std::nullopt) {
  Scene scene = sceneOf(1);
  scene.attempt = {seconds, true};
  OverlayWriter writer(font());
  addOwnResult(writer, ownResultOf(scene, run, medals), {kWidth / 2, 76});
  return linesOf(writer.take());
}
using Lines = std::vector<std::string>;

TEST(ResultsPanel, TheFirstFinishIsCelebratedWithOrWithoutAMedal) {
  const RunStatus first{.best = 12.34, .isNewBest = true};
  EXPECT_EQ(ownLines(12.34, first), (Lines{"Level complete!", "12.34 s"}));
  EXPECT_EQ(ownLines(25, first, kMedals), (Lines{"Level complete!", "25.00 s", "Bronze medal in 20.00 s or less"}));
  EXPECT_EQ(ownLines(20, first, kMedals),
            (Lines{"Level complete!", "★☆☆", "20.00 s", "Bronze medal. Silver in 15.00 s or less"}));
  EXPECT_EQ(ownLines(15, first, kMedals),
            (Lines{"Level complete!", "★★☆", "15.00 s", "Silver medal. Gold in 10.00 s or less"}));
  EXPECT_EQ(ownLines(10, first, kMedals), (Lines{"Level complete!", "★★★", "10.00 s", "Gold medal"}));
}

TEST(ResultsPanel, LaterOnesTellTheDifferenceToTheBest) {
  EXPECT_EQ(ownLines(12.34, {.best = 12.34, .difference = -0.5, .isNewBest = true}),
            (Lines{"New best time!", "12.34 s (−0.50 s)"}));
  EXPECT_EQ(ownLines(12.34, {.best = 11.84, .difference = 0.5}), (Lines{"Goal!", "12.34 s (+0.50 s)"}));
  EXPECT_EQ(ownLines(12.34, {}), (Lines{"Goal!", "12.34 s"}));
}

TEST(ResultsPanel, StarsAreLargeAndHaveTheColourOfTheMedal) {
  Scene scene = sceneOf(1);
  scene.attempt = {15, true};
  OverlayWriter writer(font());
  addOwnResult(writer, ownResultOf(scene, {}, kMedals), {kWidth / 2, 76});
  const Overlay panel = writer.take();
  for (const Overlay::Text& text : panel.texts) {
    if (text.content != "★★☆") continue;
    EXPECT_EQ(text.colour, colourOf(Medal::kSilver));
    EXPECT_GE(text.size, 3 * kSmallestText);
    return;
  }
  ADD_FAILURE() << "no stars";
}

TEST(ResultsPanel, APlayerWhoIsAloneReadsTheKeysToGoOn) {
  EXPECT_EQ(ownKeysOf({.nextTitle = "Corners"}, KeyHints(), font()),
            "Enter: next level (Corners) · R: try again · Esc: menu");
}

TEST(ResultsPanel, TheOwnResultIsShownAtTheGoalOfARoundThatWaits) {
  Scene scene = sceneOf(1);
  EXPECT_FALSE(showsOwnResult(scene, {.waits = true}));
  scene.attempt = {12.34, true};
  EXPECT_TRUE(showsOwnResult(scene, {.waits = true}));
  EXPECT_FALSE(showsOwnResult(scene, {.waits = false}));
  scene.attempt->arrived = false;
  EXPECT_FALSE(showsOwnResult(scene, {.waits = true})) << "the player tries again";
  scene.isTeam = true;
  scene.teamSeconds = 60;
  EXPECT_TRUE(showsOwnResult(scene, {.waits = true})) << "the other one is there, while this one holds the door";
  EXPECT_EQ(ownResultOf(scene, {}, kMedals).time, "60.00 s");
}

TEST(ResultsPanel, TellsThatASlowedGameIsNotKept) {
  EXPECT_EQ(ownLines(12.34, {.speed = 0.75}, kMedals), (Lines{"Goal!", "12.34 s at 75 % speed, not kept"}));
}

TEST(ResultsPanel, AlsoTheResultsOfARoundWithATimeLimitTellIt) {
  Scene scene = sceneOf(1);
  scene.attempt = {12.34, true};
  EXPECT_EQ(linesOf(panelOf(scene, {.nextTitle = "Corners"}, {.speed = 0.75})),
            (std::vector<std::string>{"Time is up", "Name1 | –", "Your time: at 75 % speed, not kept",
                                      "Nobody has reached the goal yet", "Next level: Corners"}));
}

TEST(ResultsPanel, TellsThatARunIsTooLongToBeRecorded) {
  EXPECT_EQ(ownLines(2000, {.notRecorded = "too long to be recorded"}),
            (Lines{"Goal!", "2000.00 s, too long to be recorded"}));
}

}  // namespace
}  // namespace platon::results_panel_test
