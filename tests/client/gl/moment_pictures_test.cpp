// Golden pictures of moments that pass: the solid is folded, an edge is crossed, the goal is reached, ghosts run along.

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "platon/game/game.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"
#include "tests/support/files.h"

namespace platon::moment_pictures_test {
namespace {

class MomentPicturesTest : public testing::Test {
 protected:
  MomentPicturesTest() { view_.setQuality(kBestQuality); }

  static Scene sceneOfSolid(const std::string& solid) {
    const LevelResult result = loadLevel(readText("tests/determinism/golden/levels/" + solid + ".level"));
    const auto stage = makeStageModel(*result.level);
    Scene scene = sceneOf(stage, {playerAt(*stage, 0, stage->start.face, stage->start.place)});
    scene.players.back().local = true;
    scene.focus = scene.players.back().pose;
    scene.elements = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
    scene.attempt = AttemptDrawing{12.34, false};
    return scene;
  }

  // Without the display.
  void draw(const Scene& scene, double seconds) {
    Settings settings;
    settings.zoom = zoom_;
    view_.draw(&scene, {.underMenu = true}, settings, Overlay(), seconds);
  }

  // Moves the local player of the scene, and the camera with it.
  static void put(Scene& scene, const Pose& pose) {
    scene.players.back().pose = pose;
    scene.focus = pose;
  }

  const Offscreen context_;
  GameView view_{320, 180};
  double zoom_ = 2;
};

TEST_F(MomentPicturesTest, TheSolidIsHalfFolded) {
  const Scene scene = sceneOfSolid("dodecahedron");
  zoom_ = 1;
  view_.setFlights(true);
  draw(scene, 0);
  draw(scene, 1);
  ASSERT_TRUE(view_.flying());
  expectGolden(view_.read(), "moment/folding");
}

TEST_F(MomentPicturesTest, AnEdgeIsLitAndAnArrowPointsDown) {
  Scene scene = sceneOfSolid("hexahedron");
  const SolidMesh& mesh = scene.stage->mesh;
  constexpr int kEdge = 2;  // above the place where the ball is
  const int face = scene.stage->start.face;
  const int beyond = mesh.solid().neighbour(face, kEdge).face;
  const glm::dvec2 outwards = mesh.edgeNormals()[kEdge];
  const double angle = std::atan2(outwards.y, outwards.x) - std::acos(0.0);
  const glm::dvec3 edge = mesh.toWorld(face, mesh.apothem() * outwards);
  for (int frame = 12; frame > 0; --frame) {
    put(scene, mesh.pose(face, (mesh.apothem() - 2 * frame) * outwards, angle));
    draw(scene, 0.02);
    scene.seconds += 0.02;
  }
  const glm::dvec3 up = rotatedBetween(scene.focus.up, mesh.normal(face), mesh.normal(beyond));
  for (int frame = 1; frame <= 10; ++frame) {
    put(scene, {edge + 2.0 * frame * up, up, mesh.normal(beyond)});
    draw(scene, 0.02);
    scene.seconds += 0.02;
  }
  expectGolden(view_.read(), "moment/new_down");
}

TEST_F(MomentPicturesTest, TheGoalHasOpened) {
  Scene scene = sceneOfSolid("octahedron");
  const Marker& goal = scene.stage->goal;
  put(scene, scene.stage->mesh.pose(goal.face, goal.place + glm::vec2(60, 0), 0));
  draw(scene, 0);
  scene.attempt->arrived = true;
  for (const double seconds : {0.1, 1.0, 3.0}) {
    scene.seconds = seconds;
    draw(scene, 0.1);
  }
  expectGolden(view_.read(), "moment/portal");
}

// The ball is behind the solid.
TEST_F(MomentPicturesTest, ALongFallIsSeenFromAfarWithARingRoundTheBall) {
  Scene scene = sceneOfSolid("icosahedron");
  const SolidMesh& mesh = scene.stage->mesh;
  zoom_ = 1;
  draw(scene, 0);
  scene.longFall = true;
  draw(scene, 0);
  draw(scene, 2);
  put(scene, mesh.pose(mesh.faceTowards(-scene.focus.position), {10, 40}, 2));
  view_.draw(&scene, {.hint = "R: back to the start", .scale = 2}, Settings(), Overlay(), 0.1);
  expectGolden(view_.read(), "moment/long_fall");
}

TEST_F(MomentPicturesTest, GhostsRunAlong) {
  Scene scene = sceneOfSolid("icosahedron");
  const Marker& start = scene.stage->start;
  for (const float aside : {-40.0F, 40.0F}) {
    PlayerDrawing ghost = playerAt(*scene.stage, 4, start.face, start.place + glm::vec2(aside, 0));
    ghost.opacity = 0.5F;
    ghost.pattern = BallPattern::kPlain;
    ghost.number = "\u25cb";
    if (aside < 0) ghost.colour = Colour(1);  // the own one
    scene.ghosts.push_back(ghost);
  }
  draw(scene, 0);
  expectGolden(view_.read(), "moment/ghosts");
}

}  // namespace
}  // namespace platon::moment_pictures_test
