#include "client/gl/paint/ball_painter.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/client/gl/render_fixture.h"

namespace platon::ball_painter_test {
namespace {

// The mark was as bright as a bright ball.
TEST_F(RenderTest, TheMarkOfUpHasADarkRim) {
  const auto stage = cube();
  PlayerDrawing player = playerAt(*stage, 0, 0, {40, 30});
  player.pattern = BallPattern::kPlain;
  player.number = "";
  player.colour = Colour(1);
  camera_.setZoom(4);
  Scene scene = sceneOf(stage, {player});
  scene.focus = player.pose;
  const Image image = draw(scene, kStill);
  // A point of the ball so far from the middle of the mark, radians towards its side.
  const auto brightnessAt = [&](double angle) {
    const glm::dvec3 mark = glm::normalize(player.pose.up + 0.9 * player.pose.normal);
    const glm::dvec3 way = std::cos(angle) * mark + std::sin(angle) * glm::cross(player.pose.up, player.pose.normal);
    return brightness(pixel(image, pixelOf(centreOf(player) + StageModel::kPlayerRadius * way)));
  };
  EXPECT_GT(brightnessAt(0), 0.95);
  EXPECT_LT(brightnessAt(0.33), 0.65);
  EXPECT_GT(brightnessAt(0.55), 0.75);
}

}  // namespace
}  // namespace platon::ball_painter_test
