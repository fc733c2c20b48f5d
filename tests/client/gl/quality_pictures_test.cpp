// A golden picture for each level of quality.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "client/gl/renderer.h"
#include "client/quality/quality.h"
#include "platon/game/game.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"
#include "tests/support/files.h"

namespace platon::quality_pictures_test {
namespace {

constexpr std::uint32_t kWidth = 480;
constexpr std::uint32_t kHeight = 270;

Scene matchScene() {
  const LevelResult result = loadLevel(readText("levels/data/dodecahedron/21_leap_for_the_key.level"));
  const auto stage = makeStageModel(*result.level);
  std::vector<PlayerDrawing> players;
  for (std::uint32_t slot = 0; slot < 3; ++slot) {
    players.push_back(playerAt(*stage, slot, stage->start.face, stage->start.place + glm::vec2(40 * slot, 0)));
    players.back().name = "Player " + players.back().number;
  }
  players.front().local = true;
  std::rotate(players.begin(), players.begin() + 1, players.end());
  Scene scene = sceneOf(stage, players);
  scene.focus = players.back().pose;
  scene.elements = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
  scene.seconds = 2;
  scene.secondsLeft = 298;
  scene.attempt = AttemptDrawing{1.5, false};
  return scene;
}

// Without the head-up display.
Image pictureIn(const Quality& quality) {
  const Font font;
  Renderer renderer(kWidth, kHeight, font);
  renderer.setQuality(quality);
  const Scene scene = matchScene();
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, kWidth, kHeight);
  renderer.draw(scene, camera, {}, PictureStyle());
  EXPECT_EQ(takeGlErrors(), "");
  return renderer.read();
}

TEST(QualityPictures, EachLevelLooksAsBefore) {
  const Offscreen context;
  for (const NamedQuality& named : kQualities)
    expectGolden(pictureIn(named.quality), "quality_" + std::string(named.name));
}

TEST(QualityPictures, TheLevelsDiffer) {
  const Offscreen context;
  for (std::size_t i = 1; i < kQualities.size(); ++i)
    EXPECT_NE(pictureIn(kQualities[i - 1].quality), pictureIn(kQualities[i].quality)) << kQualities[i].name;
}

// A panel hides the scene. Its text is the same at any scale.
TEST(QualityPictures, TextsKeepTheirFullSize) {
  const Offscreen context;
  Overlay menu;
  menu.panels.push_back({{0, 0}, {1280, 720}, 0, {0, 0, 0, 1}});
  menu.texts.push_back({{100, 300}, 40, {1, 1, 1, 1}, "Platon"});
  std::vector<Image> images;
  for (const double scale : {1.0, 0.75, 0.5}) {
    GameView view(kWidth, kHeight);
    view.setQuality({1, scale, true, true});
    const Scene scene = matchScene();
    view.draw(&scene, {}, Settings(), menu, 0.1);
    images.push_back(view.read());
  }
  EXPECT_EQ(images[1], images[0]);
  EXPECT_EQ(images[2], images[0]);
}

}  // namespace
}  // namespace platon::quality_pictures_test
