#include "client/gl/renderer.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/client/gl/render_fixture.h"
#include "tests/client/gl/test_stage.h"

namespace platon::picture_style_test {
namespace {

class PictureStyleTest : public RenderTest {};

TEST_F(PictureStyleTest, WithReducedMotionTwoMomentsDifferOnlyByThePlayers) {
  const auto stage = cube();
  PlayerDrawing player = playerAt(*stage, 0, 0, {-100, 60});
  player.local = true;
  Scene before = sceneOf(stage, {player});
  before.seconds = 5;
  before.attempt = AttemptDrawing{3, false};
  Scene after = before;
  // Lands, flashes and reaches the goal.
  after.seconds = 5.05;
  after.players[0].pose = stage->mesh.pose(0, {-100, 50}, 0);
  after.players[0].flash = 1;
  after.attempt->arrived = true;
  Scene later = after;
  later.seconds = 5.1;
  draw(before, kStill);
  const Image moving = draw(after, kStill);
  EXPECT_EQ(draw(later, kStill), moving) << "the player stands: nothing moves";
  const Image landed = draw(before, kStill);
  const glm::ivec2 ball = pixelOf(centreOf(player));
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const glm::ivec2 at(x, y);
      if (pixel(moving, at) == pixel(landed, at)) continue;
      const bool goal = glm::distance(glm::vec2(at), glm::vec2(pixelOf(before, {60, 80}))) < 60;  // it has opened
      EXPECT_TRUE(goal || glm::distance(glm::vec2(at), glm::vec2(ball)) < 40) << x << " " << y;
    }
  }
}

TEST_F(PictureStyleTest, WithoutFlashesPlayersAndGoalDoNotFlash) {
  const auto stage = cube();
  const PictureStyle style{.flashes = false};
  Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {-100, 60})});
  const Image plain = draw(scene, style);
  scene.players[0].flash = 1;
  EXPECT_EQ(draw(scene, style), plain);
  EXPECT_NE(draw(scene), plain);
}

TEST_F(PictureStyleTest, AnEdgeAheadIsLitUnlessMotionOrFlashesAreUnwanted) {
  renderer_.setQuality(namedQuality(QualityLevel::kMedium).quality);  // without trails
  const auto stage = cube();
  const auto lastOfARun = [&](const PictureStyle& style) {
    Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {210, 20})});
    scene.players[0].local = true;
    Image image = draw(scene, style);
    for (int i = 0; i < 9; ++i) {
      scene.seconds += 0.02;
      scene.players[0].pose.position += glm::cross(scene.players[0].pose.up, scene.players[0].pose.normal) * 3.0;
      image = draw(scene, style);
    }
    scene.seconds = 0;  // begins anew
    const Image still = draw(scene, style);
    return std::pair(brightness(pixel(image, pixelOf(scene, {237, -10}))),
                     brightness(pixel(still, pixelOf(scene, {237, -10}))));
  };
  const auto [lit, plain] = lastOfARun({});
  EXPECT_GT(lit, plain + 0.1);
  for (const PictureStyle style : {kStill, PictureStyle{.flashes = false}}) {
    const auto [before, after] = lastOfARun(style);
    EXPECT_EQ(before, after);
  }
}

TEST_F(PictureStyleTest, AnArrowPointsDownAfterACrossingUnlessMotionIsUnwanted) {
  renderer_.setQuality(namedQuality(QualityLevel::kMedium).quality);
  const auto stage = cube();
  const auto brightest = [&](const PictureStyle& style) {
    Scene scene = sceneOf(stage, {playerAt(*stage, 0, 1, {0, 238})});
    scene.players[0].local = true;
    scene.focus = scene.players[0].pose;
    draw(scene, style);
    const int beyond = stage->mesh.solid().neighbour(1, 2).face;
    const glm::dvec3 up = rotatedBetween(scene.players[0].pose.up, stage->mesh.normal(1), stage->mesh.normal(beyond));
    const glm::dvec3 edge = stage->mesh.toWorld(1, {0, 240});
    scene.players[0].pose = {edge + 4.0 * up, up, stage->mesh.normal(beyond)};
    scene.seconds += 0.02;
    draw(scene, style);
    scene.seconds += 0.4;
    scene.players[0].pose.position = edge + 60.0 * up;
    scene.focus = scene.players[0].pose;
    const Image image = draw(scene, style);
    return brightness(pixel(image, pixelOf(scene.players[0].pose.position - EdgeCrossing::kArrowBelow * up)));
  };
  EXPECT_GT(brightest({}), brightest(kStill) + 0.2);
  EXPECT_GT(brightest({.flashes = false}), brightest(kStill) + 0.2);
}

TEST_F(PictureStyleTest, ADoorMovesUnlessMotionIsUnwanted) {
  const auto stage = stageOf("HEXAHEDRON", 6, "-120 -60 120 -60 door 5\n");
  const auto shortlyAfter = [&](const PictureStyle& style, double seconds) {
    Scene scene = sceneOf(stage);
    scene.elements = {{1}, {0}, std::vector<glm::vec2>(6, glm::vec2(0, 1))};
    draw(scene, style);
    scene.elements.active = {0};
    scene.seconds = seconds;
    const Image image = draw(scene, style);
    scene.seconds = 0;
    draw(scene, style);
    return image;
  };
  EXPECT_EQ(shortlyAfter(kStill, 0.05), shortlyAfter(kStill, 1));
  const PictureStyle style{.highContrast = true};  // without motes and trails
  EXPECT_NE(shortlyAfter(style, 0.05), shortlyAfter(style, 1));
}

TEST_F(PictureStyleTest, HighContrastIsADarkGroundWithBrightWalls) {
  const auto stage = cube();
  const Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {-100, 60})});
  const Image image = draw(scene, {.highContrast = true});
  EXPECT_LT(brightness(pixel(image, {1, 1})), 0.02);
  EXPECT_LT(brightness(pixel(image, pixelOf(scene, {100, -60}))), 0.2);
  EXPECT_GT(brightness(pixel(image, pixelOfTop(scene, {-130, -120}))), 0.85);
}

}  // namespace
}  // namespace platon::picture_style_test
