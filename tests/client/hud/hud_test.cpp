#include "client/hud/hud.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/ui/overlay.h"
#include "tests/client/ui/overlay_contrast.h"

namespace platon::hud_test {
namespace {

constexpr glm::vec2 kScreen{1280, 720};
constexpr glm::vec2 kReach{560, 300};

TEST(EdgeSign, WhatThePictureShowsHasNone) {
  for (const glm::dvec4 clip : {glm::dvec4(0, 0, 0, 1), {1, 1, 0, 1}, {-3, 2, 0, 3}})
    EXPECT_FALSE(edgeSignOf(clip, kScreen, kReach));
  EXPECT_TRUE(edgeSignOf({1.01, 0, 0, 1}, kScreen, kReach));
  EXPECT_TRUE(edgeSignOf({0, 0, 0, -1}, kScreen, kReach)) << "behind the camera";
}

// `clip` has +y up, the screen +y down.
TEST(EdgeSign, StandsOnTheRectangleInTheDirectionOfThePoint) {
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * std::numbers::pi / 180;
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    const glm::dvec4 clip(way.x * 3000 / kScreen.x, way.y * 3000 / kScreen.y, 0, 1);
    const auto sign = edgeSignOf(clip, kScreen, kReach);
    ASSERT_TRUE(sign) << degree;
    EXPECT_NEAR(sign->direction.x, way.x, 1e-5) << degree;
    EXPECT_NEAR(sign->direction.y, -way.y, 1e-5) << degree;
    const glm::vec2 offset = sign->place - kScreen / 2.0F;
    EXPECT_NEAR(std::max(std::abs(offset.x) / kReach.x, std::abs(offset.y) / kReach.y), 1, 1e-5) << degree;
    EXPECT_NEAR(glm::dot(offset, sign->direction), glm::length(offset), 1e-2) << degree;
    const auto behind = edgeSignOf(-clip, kScreen, kReach);
    ASSERT_TRUE(behind);
    EXPECT_EQ(behind->place, sign->place) << "a point behind the camera is projected to the other side";
  }
}

TEST(EdgeSign, TheArrowPointsThere) {
  const auto arrow = [](double x, double y) {
    return std::string(edgeSignOf({x, y, 0, 1}, {100, 100}, {40, 40})->arrow);
  };
  EXPECT_EQ(arrow(2, 0), "→");
  EXPECT_EQ(arrow(2, 2), "↗");
  EXPECT_EQ(arrow(0, 2), "↑");
  EXPECT_EQ(arrow(-2, 2), "↖");
  EXPECT_EQ(arrow(-2, 0), "←");
  EXPECT_EQ(arrow(-2, -0.1), "←");
  EXPECT_EQ(arrow(-2, -2), "↙");
  EXPECT_EQ(arrow(0, -2), "↓");
  EXPECT_EQ(arrow(2, -2), "↘");
}

TEST(EdgeSign, APointStraightBehindIsBelow) { EXPECT_STREQ(edgeSignOf({0, 0, 0, -1}, kScreen, kReach)->arrow, "↓"); }

const Font& font() {
  static const Font font;
  return font;
}

std::shared_ptr<const StageModel> stage() {
  const LevelResult result = loadLevel("# title: Corners\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return makeStageModel(*result.level);
}

Scene sceneOf(int players) {
  Scene scene;
  scene.stage = stage();
  scene.secondsLeft = 83;
  for (int i = 0; i < players; ++i) {
    PlayerDrawing player;
    player.slot = static_cast<std::uint32_t>(i);
    player.pose = scene.stage->mesh.pose(0, {i * 10.0 - 50, 0}, 0);
    player.number = std::to_string(i + 1);
    player.name = "Name" + player.number;
    scene.players.push_back(player);
  }
  scene.focus = scene.stage->mesh.pose(0, {0, 0}, 0);
  return scene;
}

Overlay hudOf(const Scene& scene, const HudStatus& status = HudStatus()) {
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, 1280, 720);
  return makeHud(scene, camera, status, font());
}

const Overlay::Text* find(const Overlay& overlay, const std::string& content) {
  const auto found = std::find_if(overlay.texts.begin(), overlay.texts.end(),
                                  [&](const Overlay::Text& text) { return text.content == content; });
  return found == overlay.texts.end() ? nullptr : &*found;
}

long count(const Overlay& overlay, const std::string& content) {
  return std::count_if(overlay.texts.begin(), overlay.texts.end(),
                       [&](const Overlay::Text& text) { return text.content == content; });
}

TEST(Hud, WhatPlayersSayIsOneBelowTheOtherAndInsideThePicture) {
  const std::string longest(120, 'W');
  const Overlay hud = hudOf(sceneOf(1), {.chat = {"Ann: wait", "Ben: " + longest}});
  ASSERT_NE(find(hud, "Ann: wait"), nullptr);
  for (const Overlay::Text& text : hud.texts) {
    EXPECT_GE(text.place.x, 0);
    EXPECT_LE(text.place.x + font().width(text.content) * text.size, 1280);
  }
}

// Two players of this machine, side by side. The second one's scene is `second`.
Overlay dividedHudOf(const Scene& first, const Scene& second, HudStatus status = {}) {
  status.companionKeys = {KeyHints(Bindings(KeySet::kSecond))};
  Camera camera;
  camera.set(first.focus, first.stage->mesh, 640, 720);
  const std::vector<HudPane> panes{{&first, &camera, {0, 0}, {636, 720}}, {&second, &camera, {644, 0}, {636, 720}}};
  return makeSharedHud(panes, status, font(), 1280);
}

// The scene as this player sees it.
Scene seenBy(Scene scene, std::size_t player) {
  std::swap(scene.players[player], scene.players.back());
  scene.players.back().local = true;
  return scene;
}

TEST(SharedHud, PlayersWithAPaneOfTheirOwnHaveTheirNamesInItAndNoList) {
  const Overlay two = dividedHudOf(seenBy(sceneOf(2), 0), seenBy(sceneOf(2), 1));
  EXPECT_EQ(find(two, "1"), nullptr) << "the number of a row";
  const auto titleOf = [&](const std::string& name, float middle) {
    return std::any_of(two.texts.begin(), two.texts.end(), [&](const Overlay::Text& text) {
      const float centre = text.place.x + font().width(text.content) * text.size / 2;
      return text.content == name && std::abs(centre - middle) < 1 && text.place.y < 200;
    });
  };
  EXPECT_TRUE(titleOf("Name1", 318));
  EXPECT_TRUE(titleOf("Name2", 962));
  EXPECT_NE(find(dividedHudOf(seenBy(sceneOf(3), 0), seenBy(sceneOf(3), 1)), "3"), nullptr) << "another one is listed";
}

TEST(SharedHud, ALongHintIsWrappedInThePaneOfTheFirstPlayer) {
  HudStatus status;
  status.scale = 1.75F;
  status.hint = "A door opens with the key of its number, or while somebody stands on the plate of its number";
  const Overlay hud = dividedHudOf(seenBy(sceneOf(2), 0), seenBy(sceneOf(2), 1), status);
  std::string shown;
  for (const Overlay::Text& text : hud.texts) {
    if (status.hint.find(text.content) == std::string::npos) continue;
    shown += (shown.empty() ? "" : " ") + text.content;
    EXPECT_GE(text.place.x, 0);
    EXPECT_LE(text.place.x + font().width(text.content) * text.size, 636);
  }
  EXPECT_EQ(shown, status.hint);
}

TEST(SharedHud, EachPlayerIsToldInItsPaneToGoBackToTheStart) {
  const Scene first = seenBy(sceneOf(2), 0);
  const Scene second = seenBy(sceneOf(2), 1);
  Scene lost = second;
  lost.needsRestart = true;
  const std::string text = KeyHints(Bindings(KeySet::kSecond)).to(Control::kRestart, "back to the start");
  EXPECT_EQ(find(dividedHudOf(first, second), text), nullptr);
  const Overlay hud = dividedHudOf(first, lost);
  ASSERT_NE(find(hud, text), nullptr);
  EXPECT_GT(find(hud, text)->place.x, 644);
}

TEST(Hud, ClockShowsMinutesAndThenTenths) {
  EXPECT_EQ(clockText(300), "5:00");
  EXPECT_EQ(clockText(299.01), "5:00");
  EXPECT_EQ(clockText(61), "1:01");
  EXPECT_EQ(clockText(10), "0:10");
  EXPECT_EQ(clockText(9.95), "10.0");
  EXPECT_EQ(clockText(9.9), "9.9");
  EXPECT_EQ(clockText(0), "0.0");
}

TEST(Hud, ShowsTitleClockAndMessage) {
  const Overlay hud = hudOf(sceneOf(1), {.message = "Connection lost", .warning = true, .help = false});
  EXPECT_TRUE(find(hud, "Corners"));
  EXPECT_TRUE(find(hud, "Cube · earth"));
  EXPECT_TRUE(find(hud, "1:23"));
  EXPECT_TRUE(find(hud, "Connection lost"));
}

TEST(Hud, ShowsANoticeAboveTheMessage) {
  const HudStatus status{.message = "Connection lost", .warning = true, .help = false, .notice = "Restart at noon"};
  const Overlay hud = hudOf(sceneOf(1), status);
  ASSERT_TRUE(find(hud, "Connection lost"));
  ASSERT_TRUE(find(hud, "Restart at noon"));
  EXPECT_LT(find(hud, "Restart at noon")->place.y, find(hud, "Connection lost")->place.y);
  EXPECT_TRUE(find(makeEmptyHud(status, font(), 1280), "Restart at noon"));
}

// 200 bytes, the longest text of a server, of the widest letters.
TEST(Hud, ALongTextIsShownInLinesThatFit) {
  for (const std::string& text : {std::string(200, 'W'), std::string("Wide Words ") + std::string(189, 'W')}) {
    for (const HudStatus& status : {HudStatus{.message = text}, HudStatus{.notice = text}}) {
      for (const Overlay& hud : {hudOf(sceneOf(1), status), makeEmptyHud(status, font(), 1280)}) {
        long letters = 0;
        for (const Overlay::Text& line : hud.texts) {
          EXPECT_GE(line.place.x, 0);
          EXPECT_LE(line.place.x + font().width(line.content) * line.size, 1280);
          EXPECT_LT(line.place.y, Overlay::kHeight);
          letters += std::count(line.content.begin(), line.content.end(), 'W');
        }
        EXPECT_EQ(letters, std::count(text.begin(), text.end(), 'W'));
      }
    }
  }
}

TEST(Hud, FinishedPlayersComeFirstByTheirTime) {
  Scene scene = sceneOf(3);
  scene.players[2].finishSeconds = 12.34;
  scene.players[1].finishSeconds = 40;
  const Overlay hud = hudOf(scene);
  ASSERT_TRUE(find(hud, "✓ 12.34 s"));
  ASSERT_TRUE(find(hud, "✓ 40.00 s"));
  // The list of players is on the right; a name further left is a tag.
  const auto row = [&](const std::string& name) {
    float lowest = 0;
    for (const Overlay::Text& text : hud.texts) {
      if (text.content == name && text.place.x > 1000) lowest = text.place.y;
    }
    return lowest;
  };
  EXPECT_LT(row("Name3"), row("Name2"));
  EXPECT_LT(row("Name2"), row("Name1"));
}

TEST(Hud, TheListOfPlayersTellsTheKnownRoundTrips) {
  Scene scene = sceneOf(3);
  EXPECT_FALSE(find(hudOf(scene), "24 ms"));
  scene.players[1].roundTripMs = 24;
  scene.players[1].finishSeconds = 12.34;
  const Overlay hud = hudOf(scene);
  const Overlay::Text* const trip = find(hud, "24 ms");
  const Overlay::Text* const time = find(hud, "✓ 12.34 s");
  ASSERT_TRUE(trip && time);
  EXPECT_EQ(trip->place.y, time->place.y);
  EXPECT_LT(time->place.x + font().width(time->content) * time->size, trip->place.x);
  EXPECT_LE(trip->place.x + font().width(trip->content) * trip->size, 1280.0F - 16);
}

TEST(Hud, ShowsTheResultOfTheLocalPlayer) {
  Scene scene = sceneOf(2);
  scene.players[1].local = true;
  scene.players[1].finishSeconds = 7.5;
  scene.attempt = {7.5, true};
  EXPECT_TRUE(find(hudOf(scene), "✓ Goal in 7.50 s"));
  EXPECT_TRUE(find(hudOf(scene, {.timer = false}), "✓ Goal in 7.50 s")) << "also without the timer";
  scene.attempt = {1, false};
  EXPECT_FALSE(find(hudOf(scene), "✓ Goal in 7.50 s")) << "after a restart";
}

TEST(Hud, AloneTheOwnTimeIsTheOnlyClock) {
  Scene scene = sceneOf(1);
  scene.timed = false;
  scene.players[0].local = true;
  scene.attempt = {7.5, false};
  const Overlay hud = hudOf(scene, {.run = {.best = 6.0}});
  EXPECT_FALSE(find(hud, "1:23"));
  ASSERT_TRUE(find(hud, "7.50 s"));
  ASSERT_TRUE(find(hud, "personal best 6.00 s"));
  EXPECT_LT(find(hud, "7.50 s")->place.y, find(hud, "personal best 6.00 s")->place.y);
  EXPECT_EQ(count(hud, "Name1"), 0) << "and there is no list of one player";
}

// How often a figure stands in the texts.
long mentions(const Overlay& overlay, const std::string& figure) {
  return std::count_if(overlay.texts.begin(), overlay.texts.end(),
                       [&](const Overlay::Text& text) { return text.content.find(figure) != std::string::npos; });
}

TEST(Hud, TheResultsTellEachTimeOnce) {
  Scene scene = sceneOf(1);
  scene.timed = false;
  scene.players[0].local = true;
  scene.players[0].finishSeconds = 7.5;
  scene.attempt = {7.5, true};
  const RunStatus best{.best = 7.5, .isNewBest = true};
  const RoundSummary alone{
      .nextTitle = "Edges", .bestSeconds = 7.5, .bestName = "Name1", .bestIsNew = true, .waits = true};
  const Overlay own = hudOf(scene, {.summary = alone, .run = best});
  EXPECT_EQ(mentions(own, "7.50"), 1);
  EXPECT_TRUE(find(own, "Enter: next level (Edges) · R: try again · Esc: menu"));
  scene = sceneOf(3);
  scene.players[2].local = true;
  scene.players[2].finishSeconds = 7.5;
  scene.attempt = {7.5, true};
  const RoundSummary shared{
      .nextTitle = "Edges", .secondsLeft = 5, .bestSeconds = 7.5, .bestName = "Name3", .bestIsNew = true};
  EXPECT_EQ(mentions(hudOf(scene, {.summary = shared, .run = best}), "7.50"), 1);
}

// On levels 2, 9 and 10 the panel lay over the goal and the ball in it.
TEST(Hud, TheResultIsBelowABallInTheUpperPartOfThePicture) {
  Scene scene = sceneOf(1);
  scene.players.back().local = true;
  scene.attempt = {7.5, true};
  const HudStatus status{.summary = RoundSummary{.nextTitle = "Edges", .waits = true},
                         .medals = MedalTimes{400, 500, 600}};
  const auto panelWithBallAt = [&](double height) {
    scene.players.back().pose = scene.stage->mesh.pose(0, {0, height}, 0);
    const Overlay hud = hudOf(scene, status);
    const Overlay::Text* const headline = find(hud, "Goal!");
    EXPECT_NE(headline, nullptr) << height;
    return headline != nullptr ? headline->place.y : 0;
  };
  EXPECT_LT(panelWithBallAt(0), 150);
  EXPECT_LT(panelWithBallAt(-150), 150);
  EXPECT_GT(panelWithBallAt(150), Overlay::kHeight / 2);
}

TEST(Hud, TheResultsLeaveTheMiddleOfThePictureFree) {
  Scene scene = sceneOf(12);
  scene.players.back().local = true;
  scene.attempt = {7.5, true};
  for (const bool waits : {false, true}) {
    const Overlay hud = hudOf(scene, {.summary = RoundSummary{.nextTitle = std::string(100, 'W'), .waits = waits},
                                      .medals = MedalTimes{400, 500, 600}});
    for (const Overlay::Panel& panel : hud.panels) {
      const bool middle = panel.low.x < 940 && panel.high.x > 320 && panel.low.y < 560 && panel.high.y > 290;
      EXPECT_FALSE(middle) << panel.low.x << " " << panel.low.y;
    }
  }
}

TEST(Hud, ShowsTheVoteAndWhetherTheLocalPlayerHasVoted) {
  EXPECT_TRUE(find(hudOf(sceneOf(3), {.vote = VoteStatus{1, 3, false}}), "1 of 3 wants the next level (V)"));
  EXPECT_TRUE(find(hudOf(sceneOf(3), {.vote = VoteStatus{2, 4, true}}), "✓ 2 of 4 want the next level (V)"));
}

TEST(Hud, ShowsTheResultsOfARoundThatHasEnded) {
  EXPECT_FALSE(find(hudOf(sceneOf(1)), "Next level in 5 s: Corners"));
  EXPECT_TRUE(find(hudOf(sceneOf(1), {.summary = RoundSummary{"Corners", 5}}), "Next level in 5 s: Corners"));
}

TEST(Hud, ShowsTheOwnTimeBelowTheClock) {
  Scene scene = sceneOf(2);
  EXPECT_FALSE(find(hudOf(scene), "your time 0.00 s")) << "without a local player";
  scene.players[1].local = true;
  scene.attempt.emplace();
  const Overlay hud = hudOf(scene);
  ASSERT_TRUE(find(hud, "your time 0.00 s"));
  EXPECT_GT(find(hud, "your time 0.00 s")->place.y, find(hud, "1:23")->place.y);
  EXPECT_LT(find(hud, "your time 0.00 s")->size, find(hud, "1:23")->size);
  scene.attempt->seconds = 83.25;
  EXPECT_TRUE(find(hudOf(scene), "your time 83.25 s"));
  scene.players[1].finishSeconds = 61.02;
  EXPECT_TRUE(find(hudOf(scene), "best 61.02 s"));
  scene.attempt->arrived = true;
  EXPECT_TRUE(find(hudOf(scene), "✓ Goal in 83.25 s"));
  scene.players[1].finishSeconds = 83.25;
  EXPECT_TRUE(find(hudOf(scene), "✓ Goal in 83.25 s")) << "the best time itself";
}

TEST(Hud, ShowsThatRReturnsToTheStart) {
  Scene scene = sceneOf(1);
  EXPECT_FALSE(find(hudOf(scene), "R: back to the start"));
  scene.needsRestart = true;
  const Overlay hud = hudOf(scene, {.message = "Connection lost", .notice = "Restart at noon"});
  ASSERT_TRUE(find(hud, "R: back to the start"));
  EXPECT_LT(find(hud, "R: back to the start")->place.y, find(hud, "Restart at noon")->place.y);
}

TEST(Hud, InALongFallARingShowsWhereTheOwnBallIs) {
  Scene scene = sceneOf(1);
  EXPECT_FALSE(find(hudOf(scene), "\u25cb"));
  scene.longFall = true;
  EXPECT_TRUE(find(hudOf(scene), "\u25cb"));
}

TEST(Hud, ShowsThatTheLevelNeedsMorePlayers) {
  Scene scene = sceneOf(1);
  scene.neededPlayers = 2;
  EXPECT_TRUE(find(hudOf(scene), "This level needs 2 players. F2: another one joins here · V: next level"));
  scene.needsRestart = true;
  EXPECT_FALSE(find(hudOf(scene), "This level needs 2 players. F2: another one joins here · V: next level"))
      << "one hint at a time";
}

// Columns: key, button of a gamepad, meaning.
TEST(Hud, TheColumnsOfTheHelpDoNotOverlap) {
  const Overlay hud = hudOf(sceneOf(1), {.help = true});
  for (const Overlay::Text& text : hud.texts) {
    const float end = text.place.x + font().width(text.content) * text.size;
    for (const Overlay::Text& other : hud.texts) {
      const bool beside = other.place.y == text.place.y && other.place.x > text.place.x;
      EXPECT_TRUE(!beside || other.place.x > end + 6) << text.content << " and " << other.content;
    }
  }
  EXPECT_TRUE(find(hud, "fall faster"));
  EXPECT_TRUE(find(hud, "run slower"));
  EXPECT_TRUE(find(hud, "stick: 3 speeds"));
}

TEST(Hud, OnlyVisibleOtherPlayersHaveNameTags) {
  Scene scene = sceneOf(2);
  EXPECT_EQ(count(hudOf(scene), "Name1"), 2);
  scene.players[1].local = true;
  EXPECT_EQ(count(hudOf(scene), "Name2"), 1) << "the local player has no tag";
  for (int face = 0; face < 6; ++face) {
    scene.players[0].pose = scene.stage->mesh.pose(face, {0, 0}, 0);
    EXPECT_EQ(count(hudOf(scene), "Name1"), face == 0 ? 2 : 1) << "face " << face;
  }
}

TEST(Hud, WhatAVisibleBallSaysIsInABubbleAboveItsName) {
  Scene scene = sceneOf(3);
  scene.players[0].says = "Hello!";
  scene.players[2].says = "Here!";
  scene.players[2].pose.normal = -scene.players[2].pose.normal;
  const Overlay hud = hudOf(scene);
  ASSERT_TRUE(find(hud, "Hello!"));
  EXPECT_FALSE(find(hud, "Here!")) << "behind the solid";
  scene.players[0].local = true;
  EXPECT_TRUE(find(hudOf(scene), "Hello!")) << "the player sees its own";
}

TEST(Hud, WhileTheSolidIsAssembledNothingPointsToPlacesOnIt) {
  const Scene scene = sceneOf(2);
  const Overlay whole = hudOf(scene);
  const Overlay assembling = hudOf(scene, {.assembling = true});
  EXPECT_EQ(count(assembling, "Name2"), count(whole, "Name2") - 1) << "the list has it still";
  EXPECT_NE(find(assembling, "Corners"), nullptr);
}

TEST(Hud, AGhostHasANameTagUnlessItWouldHideTheLocalPlayer) {
  Scene scene = sceneOf(1);
  scene.players[0].local = true;
  PlayerDrawing ghost;
  ghost.name = "Ghost";
  ghost.pose = scene.players[0].pose;
  scene.ghosts.push_back(ghost);
  EXPECT_EQ(count(hudOf(scene), "Ghost"), 0);
  scene.ghosts[0].pose.position += 4 * StageModel::kPlayerRadius * ghost.pose.up;
  EXPECT_EQ(count(hudOf(scene), "Ghost"), 1);
}

TEST(Hud, WhatIsOutOfThePictureHasASignAtTheBorder) {
  Scene scene = sceneOf(2);
  scene.players[1].local = true;
  const auto hasSign = [](const Overlay& hud, const std::string& name) {
    return std::any_of(hud.texts.begin(), hud.texts.end(),
                       [&](const Overlay::Text& text) { return text.content.ends_with(" " + name); });
  };
  EXPECT_FALSE(hasSign(hudOf(scene), "Name1"));
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, 1280, 720);
  scene.players[0].pose.position += 3000.0 * camera.up();
  const Overlay hud = hudOf(scene);
  EXPECT_TRUE(hasSign(hud, "Name1"));
  EXPECT_TRUE(find(hud, "↑ Name1"));
  EXPECT_FALSE(hasSign(hud, "Name2")) << "the local player";
}

TEST(Hud, TheTimerCanBeHidden) {
  Scene scene = sceneOf(1);
  scene.players[0].local = true;
  scene.attempt = {7.5, false};
  EXPECT_TRUE(find(hudOf(scene), "your time 7.50 s"));
  EXPECT_TRUE(find(hudOf(scene, {.run = {.best = 6.0}}), "personal best 6.00 s"));
  EXPECT_FALSE(find(hudOf(scene, {.timer = false}), "your time 7.50 s"));
}

TEST(Hud, TheListOfPlayersIsLimited) {
  const Overlay hud = hudOf(sceneOf(64));
  EXPECT_TRUE(find(hud, "and 52 more"));
  for (const Overlay::Panel& panel : hud.panels) EXPECT_LT(panel.high.y, Overlay::kHeight * 0.6F);
}

TEST(Hud, LongNamesAreCutBetweenCodePoints) {
  Scene scene = sceneOf(2);
  scene.players[0].name.clear();
  for (int i = 0; i < 40; ++i) scene.players[0].name += "ж";
  std::string wanted;
  for (int i = 0; i < 20; ++i) wanted += "ж";
  EXPECT_TRUE(find(hudOf(scene), wanted + "…"));
}

TEST(Hud, PlayersWithoutANameHaveTheirNumber) {
  Scene scene = sceneOf(2);
  scene.players[0].name.clear();
  EXPECT_EQ(count(hudOf(scene), "Player 1"), 1);
}

TEST(Hud, UnderAMenuOnlyMessagesAndNoticesAreShown) {
  Scene scene = sceneOf(3);
  scene.needsRestart = true;
  const HudStatus status{.message = "Connection lost", .help = true, .notice = "Restart at noon", .underMenu = true};
  EXPECT_EQ(hudOf(scene, status).texts.size(), 2U);
}

TEST(Hud, ShowsHelpOnRequest) {
  EXPECT_FALSE(find(hudOf(sceneOf(1)), "run"));
  EXPECT_TRUE(find(hudOf(sceneOf(1), {.message = "", .warning = false, .help = true}), "run"));
}

// The picture behind may be white. A text without a panel has a dark seam.
TEST(Hud, TextsOnPanelsStandOutFromTheirGround) {
  HudStatus status{.message = "Connection lost", .warning = true, .help = true, .notice = "Restart at noon"};
  status.vote = VoteStatus{2, 3, true};
  status.run = {.best = 10, .difference = 2.5};
  status.chat = {"Ann: wait for me"};
  for (const Overlay& hud : {hudOf(sceneOf(3), status), makeEmptyHud(status, font(), 1280)}) {
    for (const Overlay::Text& text : hud.texts) {
      if (text.content.empty()) continue;
      const glm::vec3 ground = groundOf(hud, text, font(), glm::vec3(1));
      const bool hasSeam = text.colour == overlay_colours::kBright || text.colour.a < 1;  // titles and name tags
      if (ground == glm::vec3(1) && hasSeam) continue;
      EXPECT_GE(contrast(glm::vec3(text.colour), ground), 4.5F) << text.content;
    }
  }
}

TEST(Hud, ShowsTheMessageWithoutAGame) {
  const Overlay hud = makeEmptyHud({.message = "Connecting", .warning = false, .help = false}, font(), 1280);
  EXPECT_TRUE(find(hud, "Connecting"));
  EXPECT_TRUE(find(hud, "Platon"));
}

}  // namespace
}  // namespace platon::hud_test
