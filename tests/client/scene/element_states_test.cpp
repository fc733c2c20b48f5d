#include "client/scene/element_states.h"

#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "platon/physics/map_part.h"
#include "shared/game/game_rules.h"

namespace platon::element_states_test {
namespace {

std::shared_ptr<const Level> levelOf(SolidKind kind, const std::string& segmentsOfEachFace) {
  std::string text = std::string(nameOf(kind)) + "\n0 0 0 0\n1 0 0\n480\n";
  for (int face = 0; face < PlatonicSolid::of(kind).faces(); ++face) text += "%\n" + segmentsOfEachFace;
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

// An `up` segment of each edge.
std::string everyUp(SolidKind kind) {
  std::string lines;
  for (int edge = 0; edge < PlatonicSolid::of(kind).edgesPerFace(); ++edge) {
    const int x = 15 * edge;
    lines += std::to_string(x) + " -60 " + std::to_string(x + 10) + " -60 up " + std::to_string(edge) + "\n";
  }
  return lines;
}

// Whether the rules of the game let a player of face 0 with this up pass an element of `face`, which is turned by
// `turn` against face 0.
bool passes(const Level& level, Angle up, const Element& element, Angle turn) {
  World world = level.world;
  Entity entity(world, playerShape());
  MapPart(world, 0).insert(entity, Point(0, 0), up);
  std::vector<PlayerState> players(1);
  UnitNormals normals;
  TouchedElements touched;
  const GameRules rules(level, world, players, normals, touched, {});
  SegmentRef segment{element.face, element.segment, false, element.ends};
  segment.toHome = Angle() - turn;
  return rules.pierce(entity, segment);
}

TEST(ElementStates, TheUpPointsToTheEdgeWhoseElementsBlock) {
  for (int i = 0; i < kSolidKinds; ++i) {
    const auto kind = static_cast<SolidKind>(i);
    const auto level = levelOf(kind, everyUp(kind));
    const SolidMesh mesh(kind, level->faceSize);
    std::vector<Angle> turns(static_cast<std::size_t>(mesh.faces()));
    std::vector<bool> near(turns.size());
    near[0] = true;
    for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
      const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(0, edge);
      turns[next.face] = next.turn;
      near[next.face] = true;
    }
    for (int degrees = 0; degrees < 360; degrees += 3) {
      const Angle up(degrees * 100);
      const Pose pose = mesh.pose(0, {0, 0}, toRadians(up));
      for (const Element& element : level->elements) {
        if (!near[element.face]) continue;
        const glm::dvec2 carried = carriedUp(mesh, pose, static_cast<int>(element.face));
        const bool towards = edgeTowards(carried, mesh.solid().edgesPerFace()) == element.number;
        EXPECT_EQ(towards, !passes(*level, up, element, turns[element.face]))
            << nameOf(kind) << " " << degrees << " face " << element.face << " edge " << int{element.number};
      }
    }
  }
}

// On a triangle, an up may point to a corner. What stands upright for the player follows it, not the next edge.
TEST(ElementStates, AnUpThatPointsToACornerIsCarriedAsItIs) {
  const SolidMesh mesh(SolidKind::kIcosahedron, 480);
  const Pose pose = mesh.pose(0, {0, 0}, 0);
  EXPECT_LT(glm::distance(carriedUp(mesh, pose, 0), {0, 1}), 1e-9);
  for (int edge = 0; edge < 3; ++edge) {
    const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(0, edge);
    const double turn = toRadians(next.turn);
    const glm::dvec2 expected(-std::sin(turn), std::cos(turn));
    EXPECT_LT(glm::distance(carriedUp(mesh, pose, static_cast<int>(next.face)), expected), 1e-6) << edge;
  }
}

Game gameOn(const std::string& segmentsOfFace0) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n0 -150 -180 0\n5 0 0\n480\n%\n-240 -200 240 -200\n" + segmentsOfFace0 + "%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return Game(result.level);
}

void run(Game& game, int ticks, int buttons) {
  for (int tick = 0; tick < ticks; ++tick)
    game.advance(std::vector{Input{static_cast<std::uint8_t>(Input::kPresent | buttons)}});
}

ElementStates statesOf(const Game& game, std::optional<std::uint32_t> local = 0) {
  return elementStatesOf(game, local, SolidMesh(game.level().solid, game.level().faceSize));
}

using States = std::vector<std::uint8_t>;

TEST(ElementStates, AreEmptyWithoutElements) {
  Game game = gameOn("");
  run(game, 5, 0);
  EXPECT_TRUE(statesOf(game).active.empty());
  EXPECT_TRUE(statesOf(game).ups.empty());
}

TEST(ElementStates, WithoutAPlayerThoseOfTheStart) {
  const Game game = gameOn("0 0 50 0 up 2\n0 50 50 50 up 1\n0 -50 50 -50 checkpoint\n100 0 150 0 key 4\n");
  EXPECT_EQ(statesOf(game).active, (States{1, 0, 0, 1}));
  EXPECT_EQ(statesOf(game, std::nullopt).active, (States{1, 0, 0, 1}));
  EXPECT_LT(glm::distance(statesOf(game).ups[0], {0, 1}), 1e-6F);
}

TEST(ElementStates, EveryOtherKindIsActiveAtTimesAndNotAtOthers) {
  const std::set<ElementKind> constant{ElementKind::kOneway, ElementKind::kHazard};
  Game game = gameOn(
      "-170 -196 -130 -196 plate 3\n-60 -195 -60 -160 key 5\n60 -195 60 -100 door 5\n0 -195 0 -160 checkpoint\n"
      "0 100 50 100 up 0\n0 110 50 110 up 2\n0 120 50 120 oneway\n0 130 50 130 hazard\n0 140 50 140 timed 20 20\n");
  std::map<ElementKind, std::set<int>> seen;
  for (int tick = 0; tick < 100; ++tick) {
    run(game, 1, tick < 10 ? 0 : Input::kRight);
    const States active = statesOf(game).active;
    for (std::size_t i = 0; i < active.size(); ++i) seen[game.level().elements[i].kind].insert(active[i]);
  }
  for (const ElementKind kind : kElementKinds) {
    EXPECT_EQ(seen[kind], constant.contains(kind) ? std::set<int>{1} : (std::set<int>{0, 1}))
        << wordOf(kind) << ": play a level here in which it changes, or add it to those that are constant";
  }
}

TEST(ElementStates, TheClockOfATimedSegmentEmptiesAndFills) {
  Game game = gameOn("0 100 50 100 timed 4 2\n0 50 50 50 hazard\n");
  const std::vector<float> clocks{1.0F, 0.75F, 0.5F, 0.25F, 0.0F, 0.5F};
  for (std::size_t tick = 0; tick < 18; ++tick) {
    const ElementStates states = statesOf(game);
    EXPECT_EQ(states.active[0], tick % 6 < 4 ? 1 : 0) << tick;
    EXPECT_EQ(states.clocks[0], clocks[tick % 6]) << tick;
    EXPECT_EQ(states.clocks[1], 0.0F);
    run(game, 1, 0);
  }
}

TEST(ElementStates, OnewaySegmentsAndHazardsNeverChange) {
  Game game = gameOn("0 0 50 0 oneway\n0 50 50 50 hazard\n");
  run(game, 30, Input::kRight);
  EXPECT_EQ(statesOf(game).active, (States{1, 1}));
}

TEST(ElementStates, ATakenKeyOpensItsDoor) {
  Game game = gameOn("-60 -195 -60 -160 key 3\n60 -195 60 -100 door 3\n100 -195 100 -100 door 4\n");
  run(game, 10, 0);
  EXPECT_EQ(statesOf(game).active, (States{1, 1, 1}));
  run(game, 60, Input::kRight);
  EXPECT_EQ(statesOf(game).active, (States{0, 0, 1}));
}

TEST(ElementStates, APlateIsActiveWhileAPlayerStandsOnIt) {
  Game game = gameOn("-80 -190 0 -190 plate 3\n60 -195 60 -100 door 3\n");
  run(game, 10, 0);
  EXPECT_EQ(statesOf(game).active, (States{0, 1}));
  for (int tick = 0; tick < 300 && game.openDoors() == 0; ++tick)
    run(game, 1, Input::kRight | (game.tick() % 40 < 30 ? Input::kJump : 0));
  ASSERT_NE(game.openDoors(), 0u);
  EXPECT_EQ(statesOf(game).active, (States{1, 0}));
}

TEST(ElementStates, OnlyTheLastCheckpointOfTheLocalPlayerIsActive) {
  Game game = gameOn("-80 -195 -80 -160 checkpoint\n0 -195 0 -160 checkpoint\n");
  run(game, 10, 0);
  EXPECT_EQ(statesOf(game).active, (States{0, 0}));
  while (game.player(0).checkpoint != 1 && game.tick() < 200) run(game, 1, Input::kRight);
  EXPECT_EQ(statesOf(game).active, (States{1, 0}));
  while (game.player(0).checkpoint != 2 && game.tick() < 200) run(game, 1, Input::kRight);
  EXPECT_EQ(statesOf(game).active, (States{0, 1}));
  EXPECT_EQ(statesOf(game, 1).active, (States{0, 0})) << "another player's";
}

}  // namespace
}  // namespace platon::element_states_test
