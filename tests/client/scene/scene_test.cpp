#include "client/scene/scene.h"

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace platon::scene_test {
namespace {

constexpr std::array<std::string_view, 2> kNames{"Ada", "Grace"};

std::shared_ptr<const Level> levelOf(const std::string& start, const std::string& goal, const std::string& segments) {
  std::string text = "# title: Test\nHEXAHEDRON\n" + start + "\n" + goal + "\n480\n%\n" + segments;
  for (int face = 1; face < 6; ++face) text += "%\n-240 -200 240 -200\n";
  LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

std::shared_ptr<const Level> floorLevel() { return levelOf("0 -150 -180 0", "2 0 0", "-240 -200 240 -200\n"); }

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(Input::kPresent | buttons)}; }

// Advances the game; all players press the same buttons.
void run(Game& game, std::size_t players, int buttons, int ticks) {
  const std::vector<Input> inputs(players, pressing(buttons));
  for (int tick = 0; tick < ticks; ++tick) game.advance(inputs);
}

std::vector<PlayerSnapshot> playersOf(const Game& game) {
  std::vector<PlayerSnapshot> players;
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) players.push_back(snapshotOf(game, slot));
  return players;
}

using Players = std::span<const PlayerSnapshot>;

SceneSource sourceOf(const Game& game, Players before, Players now, double fraction) {
  SceneSource source;
  source.stage = makeStageModel(game.level());
  source.game = &game;
  source.others = {before, now, fraction};
  return source;
}

// The scene after the last tick.
Scene sceneOf(const Game& game) {
  const std::vector<PlayerSnapshot> players = playersOf(game);
  return makeScene(sourceOf(game, players, players, 1));
}

glm::dvec3 positionOf(const StageModel& stage, const EntityState& entity) {
  return stage.mesh.toWorld(static_cast<int>(entity.part), toUnits(entity.position));
}

bool isOnSurface(const SolidMesh& mesh, glm::dvec3 point) {
  return std::abs(glm::dot(mesh.normal(mesh.faceTowards(point)), point) - mesh.inradius()) < 1e-6;
}

TEST(Scene, GhostsAreTranslucentAndNoPlayers) {
  Game game(floorLevel());
  run(game, 1, Input::kRight, 40);
  const std::vector<PlayerSnapshot> players = playersOf(game);
  SceneSource source = sourceOf(game, players, players, 1);
  source.ghosts = {
      {{players[0], players[0], 1}, "best", true}, {{}, "absent", false}, {{players[0], players[0], 1}, "Ada", false}};
  const Scene scene = makeScene(source);
  EXPECT_EQ(scene.players.size(), 1U);
  EXPECT_EQ(scene.players[0].opacity, 1);
  ASSERT_EQ(scene.ghosts.size(), 2U);
  EXPECT_EQ(scene.ghosts[0].pose.position, scene.players[0].pose.position);
  EXPECT_EQ(scene.ghosts[0].name, "best");
  EXPECT_EQ(scene.ghosts[1].name, "Ada");
  EXPECT_EQ(scene.ghosts[0].colour, Colour(1));
  EXPECT_NE(scene.ghosts[1].colour, Colour(1));
  for (const PlayerDrawing& ghost : scene.ghosts) {
    EXPECT_LT(ghost.opacity, 1);
    EXPECT_FALSE(ghost.local);
  }
}

TEST(Scene, PlayersHaveThePositionsOfTheGame) {
  Game game(floorLevel());
  run(game, 3, Input::kRight, 40);
  const Scene scene = sceneOf(game);
  ASSERT_EQ(scene.players.size(), 3U);
  for (const PlayerDrawing& player : scene.players) {
    const EntityState& entity = game.world().entities()[player.slot];
    EXPECT_LT(glm::distance(player.pose.position, positionOf(*scene.stage, entity)), 1e-9);
    EXPECT_EQ(player.pose.normal, scene.stage->mesh.normal(static_cast<int>(entity.part)));
    EXPECT_NEAR(glm::dot(player.pose.up, player.pose.normal), 0, 1e-12);
    EXPECT_EQ(player.number, std::to_string(player.slot + 1));
  }
}

TEST(Scene, APlayerWithSeveralInstancesIsDrawnOnce) {
  Game game(levelOf("0 225 -180 0", "2 0 0", "-240 -200 240 -200\n"));
  for (int tick = 0; tick < 60 && (tick == 0 || game.world().instancesOf(0).empty()); ++tick)
    run(game, 1, Input::kRight, 1);
  ASSERT_FALSE(game.world().instancesOf(0).empty()) << "the player does not cross the edge";
  EXPECT_EQ(sceneOf(game).players.size(), 1U);
}

TEST(Scene, AbsentPlayersAreNotDrawn) {
  Game game(floorLevel());
  run(game, 3, 0, 5);
  game.advance(std::array{pressing(0), Input{}, pressing(0)});
  const Scene scene = sceneOf(game);
  ASSERT_EQ(scene.players.size(), 2U);
  EXPECT_EQ(scene.players[0].slot, 0U);
  EXPECT_EQ(scene.players[1].slot, 2U);
}

TEST(Scene, HasTheAttemptAndTheHintOfTheLocalPlayer) {
  Game game(floorLevel());
  run(game, 1, Input::kRight, 90);
  const std::vector<PlayerSnapshot> players = playersOf(game);
  SceneSource source = sourceOf(game, players, players, 1);
  source.attempt.observe(game.tick(), game.player(0));
  source.needsRestart = true;
  EXPECT_FALSE(makeScene(source).attempt) << "without a local player";
  EXPECT_FALSE(makeScene(source).needsRestart);
  source.localSlot = 0;
  ASSERT_TRUE(makeScene(source).attempt);
  EXPECT_DOUBLE_EQ(makeScene(source).attempt->seconds, 1.5);
  EXPECT_FALSE(makeScene(source).attempt->arrived);
  EXPECT_TRUE(makeScene(source).needsRestart);
  source.roundOver = true;
  EXPECT_FALSE(makeScene(source).needsRestart);
}

TEST(Scene, TellsHowManyPlayersTheLevelNeedsWhileFewerAreThere) {
  const std::string floor = "HEXAHEDRON\n0 0 -180 0\n2 0 0\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n";
  Game game(loadLevel("# players: 2\n" + floor).level);
  const auto neededPlayers = [&game](bool othersCanJoin) {
    const std::vector<PlayerSnapshot> players = playersOf(game);
    SceneSource source = sourceOf(game, players, players, 1);
    source.othersCanJoin = othersCanJoin;
    return makeScene(source).neededPlayers;
  };
  run(game, 1, 0, 5);
  EXPECT_EQ(neededPlayers(true), 2U);
  EXPECT_EQ(neededPlayers(false), 0U) << "in a replay";
  run(game, 2, 0, 5);
  EXPECT_EQ(neededPlayers(true), 0U);
}

TEST(Scene, ElementsAreThoseOfThePredictedGame) {
  Game confirmed(levelOf("0 -150 -180 0", "2 0 0", "-240 -200 240 -200\n-100 -195 -100 -160 key 3\n"));
  run(confirmed, 1, 0, 5);
  Game predicted = confirmed;
  run(predicted, 1, Input::kRight, 40);
  const std::vector<PlayerSnapshot> players = playersOf(confirmed);
  EXPECT_EQ(makeScene(sourceOf(confirmed, players, players, 1)).elements.active, std::vector<std::uint8_t>{1});
  EXPECT_EQ(makeScene(sourceOf(predicted, players, players, 1)).elements.active, std::vector<std::uint8_t>{0});
}

TEST(Scene, TheLocalPlayerIsPredictedAndTheOthersAreConfirmed) {
  Game confirmed(floorLevel());
  run(confirmed, 2, 0, 5);
  Game predicted = confirmed;
  run(predicted, 2, Input::kRight, 10);
  const std::vector<PlayerSnapshot> players = playersOf(confirmed);
  SceneSource source = sourceOf(predicted, players, players, 1);
  source.local = {snapshotOf(predicted, 0), snapshotOf(predicted, 0), 1};
  source.localSlot = 0;
  const Scene scene = makeScene(source);
  ASSERT_EQ(scene.players.size(), 2U);
  EXPECT_EQ(scene.players[0].slot, 1U);
  EXPECT_FALSE(scene.players[0].local);
  EXPECT_LT(glm::distance(scene.players[0].pose.position, positionOf(*scene.stage, confirmed.world().entities()[1])),
            1e-9);
  EXPECT_TRUE(scene.players[1].local);
  EXPECT_LT(glm::distance(scene.players[1].pose.position, positionOf(*scene.stage, predicted.world().entities()[0])),
            1e-9);
  EXPECT_EQ(scene.focus.position, scene.players[1].pose.position);
}

TEST(Scene, FractionInterpolatesBetweenTheLastTwoTicks) {
  Game game(floorLevel());
  run(game, 1, Input::kRight, 30);
  const EntityState start = game.world().entities()[0];
  const std::vector<PlayerSnapshot> before = playersOf(game);
  run(game, 1, Input::kRight, 1);
  const std::vector<PlayerSnapshot> now = playersOf(game);
  SceneSource source = sourceOf(game, before, now, 0);
  const glm::dvec3 first = positionOf(*source.stage, start);
  const glm::dvec3 last = positionOf(*source.stage, game.world().entities()[0]);
  ASSERT_GT(glm::distance(first, last), 0.5);
  for (const double fraction : {0.0, 0.25, 1.0}) {
    source.others.fraction = fraction;
    EXPECT_LT(glm::distance(makeScene(source).players[0].pose.position, glm::mix(first, last, fraction)), 1e-9);
  }
}

TEST(Scene, APlayerIsDrawnWhilePresentAtBothTicks) {
  Game game(floorLevel());
  run(game, 1, 0, 5);
  const std::vector<PlayerSnapshot> alone = playersOf(game);
  run(game, 2, 0, 1);
  const std::vector<PlayerSnapshot> both = playersOf(game);
  game.advance(std::array{pressing(0), Input{}});
  const std::vector<PlayerSnapshot> aloneAgain = playersOf(game);
  run(game, 2, 0, 1);
  const std::vector<PlayerSnapshot> bothAgain = playersOf(game);
  const auto drawn = [&game](Players before, Players now, double fraction) {
    return makeScene(sourceOf(game, before, now, fraction)).players.size();
  };
  for (const double fraction : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(drawn(alone, both, fraction), 1U);
    EXPECT_EQ(drawn(both, both, fraction), 2U);
    EXPECT_EQ(drawn(both, aloneAgain, fraction), 1U);
    EXPECT_EQ(drawn(aloneAgain, bothAgain, fraction), 1U);
  }
}

TEST(Scene, ARestartIsNotInterpolated) {
  Game game(floorLevel());
  run(game, 1, Input::kRight, 120);
  const std::vector<PlayerSnapshot> before = playersOf(game);
  run(game, 1, Input::kRestart, 1);
  const std::vector<PlayerSnapshot> now = playersOf(game);
  const Scene scene = makeScene(sourceOf(game, before, now, 0.5));
  EXPECT_LT(glm::distance(scene.players[0].pose.position, positionOf(*scene.stage, game.world().entities()[0])), 1e-9);
}

TEST(Scene, TheSmoothingOffsetIsInThePlayersFrame) {
  Game game(levelOf("0 0 0 90", "2 0 0", ""));
  run(game, 1, 0, 1);
  const std::vector<PlayerSnapshot> players = playersOf(game);
  SceneSource source = sourceOf(game, players, players, 1);
  source.localSlot = 0;
  const glm::dvec3 plain = makeScene(source).players[0].pose.position;
  source.localOffset = {3 * kSubunitsPerUnit, 5 * kSubunitsPerUnit};
  const Scene scene = makeScene(source);
  // Its up is the face's -x, its right the face's +y.
  const glm::dmat4& toWorld = scene.stage->mesh.faceToWorld(0);
  const glm::dvec3 moved = scene.players[0].pose.position - plain;
  EXPECT_NEAR(glm::dot(moved, glm::dvec3(toWorld[0])), -5, 1e-6);
  EXPECT_NEAR(glm::dot(moved, glm::dvec3(toWorld[1])), 3, 1e-6);
  EXPECT_TRUE(isOnSurface(scene.stage->mesh, scene.players[0].pose.position));
}

TEST(Scene, TheSmoothingOffsetOverAnEdgeFoldsUpWithTheFaces) {
  Game game(levelOf("0 0 236 0", "2 0 0", ""));
  run(game, 1, 0, 1);
  const std::vector<PlayerSnapshot> players = playersOf(game);
  SceneSource source = sourceOf(game, players, players, 1);
  source.localSlot = 0;
  source.localOffset = {0, 30 * kSubunitsPerUnit};
  const Scene scene = makeScene(source);
  const Pose& pose = scene.players[0].pose;
  const glm::dvec3 above = scene.stage->mesh.normal(0);
  ASSERT_LT(glm::dot(pose.normal, above), 0.5) << "the offset does not cross the edge";
  EXPECT_NEAR(glm::dot(pose.up, -above), 1, 1e-9);
}

TEST(Scene, PlayersHaveTheirNamesAndFinishTimes) {
  Game game(levelOf("0 -150 -180 0", "0 -150 -180", "-240 -200 240 -200\n"));
  run(game, 3, 0, 7);
  const std::vector<std::string> names(kNames.begin(), kNames.end());
  const std::vector<PlayerSnapshot> players = playersOf(game);
  SceneSource source = sourceOf(game, players, players, 1);
  source.names = names;
  const Scene scene = makeScene(source);
  EXPECT_EQ(scene.players[0].name, "Ada");
  EXPECT_EQ(scene.players[1].name, "Grace");
  EXPECT_EQ(scene.players[2].name, "");
  ASSERT_TRUE(scene.players[0].finishSeconds);
  EXPECT_NEAR(*scene.players[0].finishSeconds, 1.0 / kTicksPerSecond, 1e-12);
  EXPECT_TRUE(scene.over);
}

TEST(Scene, SecondsAreZeroAtTickZero) {
  const Game game(floorLevel());
  ASSERT_EQ(game.tick(), 0U);
  SceneSource source = sourceOf(game, {}, {}, 0);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    source.fraction = fraction;
    EXPECT_EQ(makeScene(source).seconds, 0) << fraction;
  }
}

TEST(Scene, TheClockIsThatOfTheGame) {
  Game game(floorLevel());
  run(game, 1, 0, 90);
  const Scene scene = sceneOf(game);
  EXPECT_NEAR(scene.seconds, 1.5, 1e-12);
  EXPECT_NEAR(scene.secondsLeft, (kRoundTicks - 90) / 60.0, 1e-9);
  EXPECT_FALSE(scene.over);
}

TEST(Scene, ARoundWithoutATimeLimitIsOverOnlyWhenTheServerSaysSo) {
  Game game(floorLevel());
  run(game, 1, 0, static_cast<int>(kRoundTicks) + 60);
  SceneSource source = sourceOf(game, {}, {}, 0);
  EXPECT_TRUE(makeScene(source).over);
  source.timed = false;
  EXPECT_FALSE(makeScene(source).over);
  EXPECT_FALSE(makeScene(source).timed);
  source.roundOver = true;
  EXPECT_TRUE(makeScene(source).over);
}

TEST(Scene, ARoundThatTheServerEndedIsOver) {
  const Game game(floorLevel());
  SceneSource source = sourceOf(game, {}, {}, 0);
  EXPECT_FALSE(makeScene(source).over);
  source.roundOver = true;
  EXPECT_TRUE(makeScene(source).over);
}

TEST(Scene, WithoutPlayersTheFocusIsTheStart) {
  const Game game(levelOf("3 40 60 90", "0 0 0", ""));
  const Scene scene = sceneOf(game);
  EXPECT_TRUE(scene.players.empty());
  EXPECT_LT(glm::distance(scene.focus.position, scene.stage->mesh.toWorld(3, {40, 60})), 1e-9);
  EXPECT_LT(glm::distance(scene.focus.up, glm::dvec3(scene.stage->mesh.faceToWorld(3) * glm::dvec4(-1, 0, 0, 0))),
            1e-9);
}

}  // namespace
}  // namespace platon::scene_test
