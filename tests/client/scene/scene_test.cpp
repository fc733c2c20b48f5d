#include "client/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
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

// The first pictures of a round have nobody yet: they took the player for one who had begun.
TEST(Scene, APlayerWhoHasNotAppearedOrNotMovedHasNotBegun) {
  Game game(floorLevel());
  const auto hasBegun = [&](std::optional<std::uint32_t> local) {
    const std::vector<PlayerSnapshot> players = playersOf(game);
    SceneSource source = sourceOf(game, players, players, 1);
    source.localSlot = local;
    if (game.slots() > 0) source.attempt.observe(game.tick(), game.player(0));
    return makeScene(source).begun;
  };
  EXPECT_TRUE(hasBegun(std::nullopt)) << "nobody is to play";
  EXPECT_FALSE(hasBegun(0));
  run(game, 1, 0, 30);
  EXPECT_FALSE(hasBegun(0));
  run(game, 1, Input::kRight, 1);
  EXPECT_TRUE(hasBegun(0));
}

// Companions are drawn from the predicted game, everybody once, and the local player last.
TEST(Scene, CompanionsAreWhereThePredictedGameHasThem) {
  Game confirmed(floorLevel());
  run(confirmed, 3, 0, 30);
  Game predicted = confirmed;
  run(predicted, 3, Input::kRight, 20);
  const std::vector<PlayerSnapshot> shown = playersOf(confirmed);
  SceneSource source = sourceOf(predicted, shown, shown, 1);
  const auto predictedPlayer = [&](std::uint32_t slot) {
    return InterpolatedPlayer{snapshotOf(predicted, slot), snapshotOf(predicted, slot)};
  };
  source.localSlot = 1;
  source.local = predictedPlayer(1);
  source.companions = {{2, predictedPlayer(2), {}}};
  source.ownBalls = {{1, {}}, {2, {.pattern = BallPattern::kBelt}}};
  const Scene scene = makeScene(source);
  ASSERT_EQ(scene.players.size(), 3U);
  EXPECT_EQ(scene.players[0].slot, 0U);
  EXPECT_EQ(scene.players[1].slot, 2U);
  EXPECT_EQ(scene.players[2].slot, 1U);
  EXPECT_FALSE(scene.players[1].local);
  EXPECT_TRUE(scene.players[2].local);
  EXPECT_EQ(scene.players[1].pattern, BallPattern::kBelt);
  EXPECT_EQ(scene.players[1].pose.position, scene.players[2].pose.position);
  EXPECT_NE(scene.players[0].pose.position, scene.players[1].pose.position) << "of the confirmed game";
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

// Before, each level began with a picture that asked for more players.
TEST(Scene, BeforeItsPlayersAppearALevelAsksForNone) {
  const std::string floor = "HEXAHEDRON\n0 0 -180 0\n2 0 0\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n";
  for (const std::string head : {"", "# players: 2\n"}) {
    const Game game(loadLevel(head + floor).level);
    SceneSource source = sourceOf(game, {}, {}, 1);
    source.othersCanJoin = true;
    EXPECT_EQ(makeScene(source).neededPlayers, 0U) << head;
  }
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

constexpr double kSize = 480;
constexpr double kLattice = 2.0 / kSubunitsPerUnit;  // error from rounding both ends to subunits
constexpr double kNear = 6;
constexpr int kSteps = 40;

double draw(std::mt19937_64& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Point toSubunits(glm::dvec2 point) {
  return {static_cast<std::int32_t>(std::lround(point.x * kSubunitsPerUnit)),
          static_cast<std::int32_t>(std::lround(point.y * kSubunitsPerUnit))};
}

PlayerSnapshot standing(int face, glm::dvec2 point, Angle angle) {
  return {static_cast<std::uint32_t>(face), toSubunits(point), angle, 0, true};
}

// The path of one tick over an edge.
struct Crossing {
  InterpolatedPlayer player;
  int face = 0;
  int edge = 0;
};

class PoseBetweenTest : public testing::TestWithParam<int> {
 protected:
  // Crosses `edge` of `face` at distance `along` from its middle and angle `slant` from its normal. The path is
  // `length` units long; the part `share` of it lies on `face`.
  Crossing crossing(int face, int edge, double along, double slant, double length, double share) const {
    const glm::dvec2 out = mesh_.edgeNormals()[static_cast<std::size_t>(edge)];
    const glm::dvec2 side(-out.y, out.x);
    const glm::dvec2 over = out * mesh_.apothem() + side * along;
    const glm::dvec2 direction = out * std::cos(slant) + side * std::sin(slant);
    const glm::dvec4 beyond(over + direction * length * (1 - share), 0, 1);
    const PlatonicSolid::Neighbour& next = mesh_.solid().neighbour(face, edge);
    const Angle up = Angle(face * 1700 + edge * 4300);
    Crossing result{{}, face, edge};
    result.player.before = standing(face, over - direction * length * share, up);
    result.player.now =
        standing(next.face, glm::dvec2(glm::inverse(mesh_.unfolded(face, edge)) * beyond), up + next.turn);
    return result;
  }

  // A pose in the frame of the edge: x along the edge, y across it, > 0 beyond it. Computed from the coordinates in
  // space only.
  struct FromEdge {
    glm::dvec2 place;
    glm::dvec2 up;
  };
  FromEdge fromEdge(const Crossing& crossing, const Pose& pose) const {
    const auto corner = static_cast<std::size_t>(crossing.edge);
    const glm::dvec3 a = mesh_.toWorld(crossing.face, mesh_.polygon()[corner]);
    const glm::dvec3 b = mesh_.toWorld(crossing.face, mesh_.polygon()[(corner + 1) % mesh_.polygon().size()]);
    const glm::dvec3 along = glm::normalize(b - a);
    const glm::dvec3 across = glm::cross(along, pose.normal);
    return {{glm::dot(pose.position - a, along), glm::dot(pose.position - a, across)},
            {glm::dot(pose.up, along), glm::dot(pose.up, across)}};
  }

  // The interpolated path is linear in the unfolded faces and on the surface; up does not turn.
  void checkCrossing(Crossing crossing) const {
    crossing.player.fraction = 0;
    const FromEdge first = fromEdge(crossing, poseBetween(mesh_, crossing.player));
    crossing.player.fraction = 1;
    const FromEdge last = fromEdge(crossing, poseBetween(mesh_, crossing.player));
    ASSERT_LT(first.place.y, 0);
    ASSERT_GT(last.place.y, 0);
    for (int step = 0; step <= kSteps; ++step) {
      crossing.player.fraction = double{1} * step / kSteps;
      const Pose pose = poseBetween(mesh_, crossing.player);
      const FromEdge now = fromEdge(crossing, pose);
      EXPECT_TRUE(isOnSurface(mesh_, pose.position));
      EXPECT_LT(glm::distance(now.place, glm::mix(first.place, last.place, crossing.player.fraction)), 1e-6);
      const int face = now.place.y < 0 ? crossing.face : static_cast<int>(crossing.player.now.part);
      EXPECT_TRUE(pose.normal == mesh_.normal(face) || std::abs(now.place.y) < 1e-6);
      EXPECT_LT(glm::distance(now.up, first.up), 1e-6);
      EXPECT_NEAR(glm::length(pose.up), 1, 1e-9);
    }
  }

  std::pair<int, int> commonCorner(int face, int other) const {
    const PlatonicSolid& solid = mesh_.solid();
    for (int a = 0; a < solid.edgesPerFace(); ++a) {
      for (int b = 0; b < solid.edgesPerFace(); ++b) {
        if (solid.vertex(face, a) == solid.vertex(other, b)) return {a, b};
      }
    }
    return {-1, -1};
  }

  // A random player on the face, within kNear units of its corner.
  PlayerSnapshot nearCorner(std::mt19937_64& random, int face, int corner) const {
    while (true) {
      const glm::dvec2 offset(draw(random, -kNear, kNear), draw(random, -kNear, kNear));
      const glm::dvec2 point = mesh_.polygon()[static_cast<std::size_t>(corner)] + offset;
      const auto outside = [&](glm::dvec2 normal) { return glm::dot(normal, point) > mesh_.apothem() - kLattice; };
      const auto& normals = mesh_.edgeNormals();
      if (glm::length(offset) < kNear && std::none_of(normals.begin(), normals.end(), outside)) {
        return standing(face, point, Angle(static_cast<std::int32_t>(random() % Angle::kTurn)));
      }
    }
  }

  void checkPath(InterpolatedPlayer player) const {
    constexpr int kFineSteps = 200;
    Pose last = poseOf(mesh_, player.before);
    for (int step = 0; step <= kFineSteps; ++step) {
      player.fraction = double{1} * step / kFineSteps;
      const Pose pose = poseBetween(mesh_, player);
      EXPECT_TRUE(isOnSurface(mesh_, pose.position));
      // The projection from the centre stretches a distance at most three times.
      EXPECT_LT(glm::distance(pose.position, last.position), 4 * 2 * kNear / kFineSteps);
      EXPECT_NEAR(glm::dot(pose.up, pose.normal), 0, 1e-9);
      EXPECT_NEAR(glm::length(pose.up), 1, 1e-9);
      last = pose;
    }
    EXPECT_LT(glm::distance(last.position, poseOf(mesh_, player.now).position), 1e-6);
  }

  SolidMesh mesh_{static_cast<SolidKind>(GetParam()), kSize};
};

TEST_P(PoseBetweenTest, APathOverAnEdgeIsLinearInTheUnfoldedFaces) {
  for (int face = 0; face < mesh_.faces(); ++face) {
    for (int edge = 0; edge < mesh_.solid().edgesPerFace(); ++edge) {
      std::mt19937_64 random(static_cast<std::uint64_t>(face * 8 + edge));
      for (int i = 0; i < 20; ++i) {
        const double length = i % 2 == 0 ? 3.2 : 24;  // a run, and more than the fastest fall
        SCOPED_TRACE("face " + std::to_string(face) + " edge " + std::to_string(edge) + " path " + std::to_string(i));
        checkCrossing(
            crossing(face, edge, draw(random, -200, 200), draw(random, -1, 1), length, draw(random, 0.05, 0.95)));
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(PoseBetweenTest, FractionsZeroAndOneAreTheEnds) {
  for (const double share : {0.1, 0.5, 0.9}) {
    InterpolatedPlayer player = crossing(1, 1, 30, 0.5, 12, share).player;
    for (const double fraction : {0.0, 1.0}) {
      player.fraction = fraction;
      const Pose drawn = poseBetween(mesh_, player);
      const Pose stands = poseOf(mesh_, fraction < 1 ? player.before : player.now);
      EXPECT_LT(glm::distance(drawn.position, stands.position), 1e-6);
      EXPECT_LT(glm::distance(drawn.up, stands.up), 1e-6);
      EXPECT_EQ(drawn.normal, stands.normal);
    }
  }
}

// The two faces need not have a common edge, and the straight path may miss it.
TEST_P(PoseBetweenTest, APathRoundAVertexStaysOnTheSurfaceAndDoesNotJump) {
  std::mt19937_64 random(1);
  for (int face = 0; face < mesh_.faces(); ++face) {
    for (int other = 0; other < mesh_.faces(); ++other) {
      for (int i = 0; i < 5; ++i) {
        const auto [corner, otherCorner] = commonCorner(face, other);
        if (corner < 0 || face == other) continue;
        SCOPED_TRACE("from " + std::to_string(face) + " to " + std::to_string(other));
        checkPath({nearCorner(random, face, corner), nearCorner(random, other, otherCorner), 0});
      }
    }
  }
}

TEST_P(PoseBetweenTest, TheUpDirectionTurnsLinearlyWithinAFace) {
  const PlayerSnapshot before = standing(2, {10, 20}, Angle(1000));
  const PlayerSnapshot now = standing(2, {14, 20}, Angle(5000));
  const Pose middle = poseBetween(mesh_, {before, now, 0.5});
  const Pose expected = mesh_.pose(2, {12, 20}, toRadians(Angle(3000)));
  EXPECT_LT(glm::distance(middle.position, expected.position), kLattice);
  EXPECT_LT(glm::distance(middle.up, expected.up), 1e-9);
}

TEST_P(PoseBetweenTest, ADistanceTooLongForOneTickIsAJump) {
  const PlayerSnapshot before = standing(0, {0, 0}, Angle());
  const auto drawnAt = [&](double distance) {
    const PlayerSnapshot now = standing(0, {distance, 0}, Angle());
    return glm::distance(poseBetween(mesh_, {before, now, 0.25}).position, mesh_.toWorld(0, {0, 0}));
  };
  EXPECT_NEAR(drawnAt(24), 6, 1e-6);
  EXPECT_NEAR(drawnAt(40), 40, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(OnEverySolid, PoseBetweenTest, testing::Range(0, kSolidKinds));

}  // namespace

}  // namespace platon::scene_test
