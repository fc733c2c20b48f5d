// A golden picture of each solid, with segments on its faces, a goal and players.

#include <string>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/gl/renderer.h"
#include "platon/game/game.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"
#include "tests/support/files.h"

namespace platon::solid_pictures_test {
namespace {

class SolidPicturesTest : public testing::TestWithParam<const char*> {};

TEST_P(SolidPicturesTest, LooksAsBefore) {
  constexpr std::uint32_t kWidth = 480;
  constexpr std::uint32_t kHeight = 270;
  const std::string solid = GetParam();
  const LevelResult result = loadLevel(readText("tests/determinism/golden/levels/" + solid + ".level"));
  const auto stage = makeStageModel(*result.level);
  const Marker& start = stage->start;
  Scene scene = sceneOf(stage, {playerAt(*stage, 1, start.face, start.place + glm::vec2(40, 0)),
                                playerAt(*stage, 0, start.face, start.place)});
  scene.players.back().local = true;
  scene.focus = scene.players.back().pose;
  scene.elements = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
  scene.seconds = 2;
  const Offscreen context;
  const Font font;
  Renderer renderer(kWidth, kHeight, font);
  Camera camera;
  camera.set(scene.focus, stage->mesh, kWidth, kHeight);
  renderer.draw(scene, camera, {}, PictureStyle());
  expectGolden(renderer.read(), "solid/" + solid);
}

INSTANTIATE_TEST_SUITE_P(All, SolidPicturesTest,
                         testing::Values("tetrahedron", "hexahedron", "octahedron", "dodecahedron", "icosahedron"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace platon::solid_pictures_test
