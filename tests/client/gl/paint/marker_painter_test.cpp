#include "client/gl/paint/marker_painter.h"

#include "client/scene/look/face_sign.h"
#include "tests/client/gl/render_fixture.h"

namespace platon::marker_painter_test {
namespace {

// A circle with a dot in its middle looked the same however its face was turned.
TEST_F(RenderTest, ASignWithOneDotShowsHowItsFaceIsTurned) {
  const auto stage = cube();
  constexpr int kCircle = 4;  // the face with this sign
  const FaceSign sign = signsOf(*stage)[kCircle];
  ASSERT_EQ(sign.corners, 7);
  ASSERT_EQ(sign.dots, 1);
  Scene scene = sceneOf(stage);
  scene.focus = stage->mesh.pose(kCircle, glm::dvec2(sign.place), 0);
  const Image image = draw(scene, kStill);
  const auto brightnessAt = [&](glm::dvec2 offset) {
    const glm::dvec2 place = glm::dvec2(sign.place) + double{sign.radius} * offset;
    return brightness(pixel(image, pixelOf(stage->mesh.toWorld(kCircle, place))));
  };
  EXPECT_LT(brightnessAt({0, -0.3}), brightnessAt({0, 0.3}) - 0.05);
  EXPECT_NEAR(brightnessAt({0, 0}), brightnessAt({0, 0.3}), 0.02);
}

}  // namespace
}  // namespace platon::marker_painter_test
