// A golden picture for each of the modes that the player may want instead of the usual picture.

#include <string>

#include <gtest/gtest.h>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "platon/game/game.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"
#include "tests/support/files.h"

namespace platon::mode_pictures_test {
namespace {

class ModePicturesTest : public testing::Test {
 protected:
  ModePicturesTest() {
    const LevelResult result = loadLevel(readText("tests/determinism/golden/levels/octahedron.level"));
    const auto stage = makeStageModel(*result.level);
    const Marker& goal = stage->goal;
    scene_ = sceneOf(stage, {playerAt(*stage, 1, goal.face, goal.place + glm::vec2(60, 0)),
                             playerAt(*stage, 0, goal.face, goal.place)});
    scene_.players.front().flash = 1;
    scene_.players.back().flash = 1;
    scene_.players.back().local = true;
    scene_.focus = scene_.players.back().pose;
    scene_.elements = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
    scene_.attempt = AttemptDrawing{12.34, false};
  }

  // The moment after the local player has reached the goal, without the display.
  void expectMode(const Settings& settings, const std::string& name) {
    GameView view(480, 270);
    view.setQuality(kBestQuality);
    scene_.seconds = 2;
    view.draw(&scene_, {.underMenu = true}, settings, Overlay(), 0.05);
    scene_.attempt->arrived = true;
    scene_.seconds = 2.1;
    view.draw(&scene_, {.underMenu = true}, settings, Overlay(), 0.05);
    expectGolden(view.read(), "mode/" + name);
  }

  const Offscreen context_;
  Scene scene_;
};

TEST_F(ModePicturesTest, Usual) { expectMode(Settings(), "usual"); }

TEST_F(ModePicturesTest, HighContrast) {
  Settings settings;
  settings.highContrast = true;
  expectMode(settings, "high_contrast");
}

TEST_F(ModePicturesTest, WithoutFlashes) {
  Settings settings;
  settings.flashes = false;
  expectMode(settings, "without_flashes");
}

TEST_F(ModePicturesTest, ReducedMotion) {
  Settings settings;
  settings.comfort.reducedMotion = true;
  expectMode(settings, "reduced_motion");
}

TEST_F(ModePicturesTest, FaceNumbers) {
  Settings settings;
  settings.faceNumbers = true;
  expectMode(settings, "face_numbers");
}

}  // namespace
}  // namespace platon::mode_pictures_test
