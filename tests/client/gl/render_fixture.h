#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/gl/renderer.h"
#include "client/scene/walls.h"
#include "tests/client/gl/test_stage.h"

namespace platon {

inline constexpr std::uint32_t kWidth = 640;
inline constexpr std::uint32_t kHeight = 360;
inline constexpr PictureStyle kStill{.animated = false};

/// Draws scenes without a window, and finds points in the last picture.
class RenderTest : public testing::Test {
 protected:
  // Draws the scene without overlays.
  Image draw(const Scene& scene, const PictureStyle& style = PictureStyle()) {
    camera_.set(scene.focus, scene.stage->mesh, kWidth, kHeight);
    renderer_.draw(scene, camera_, {}, style);
    EXPECT_EQ(takeGlErrors(), "");
    return renderer_.read();
  }
  Image drawEmpty() {
    renderer_.drawEmpty({});
    return renderer_.read();
  }
  // The pixel at which the last picture shows a point.
  glm::ivec2 pixelOf(glm::dvec3 point) const {
    const glm::dvec4 clip = camera_.viewProjection() * glm::dvec4(point, 1);
    return {static_cast<int>((clip.x / clip.w + 1) / 2 * kWidth),
            static_cast<int>((1 - clip.y / clip.w) / 2 * kHeight)};
  }
  // The pixel at which the last picture shows a point on top of a wall of face 0.
  glm::ivec2 pixelOfTop(const Scene& scene, glm::dvec2 point) const {
    return pixelOf(scene.stage->mesh.toWorld(0, point) + Wall::kHeight * scene.stage->mesh.normal(0));
  }
  static glm::dvec3 centreOf(const PlayerDrawing& player) {
    return player.pose.position + StageModel::kPlayerRadius * player.pose.normal;
  }
  // The pixel at which the last picture shows a point of face 0.
  glm::ivec2 pixelOf(const Scene& scene, glm::dvec2 point) const {
    return pixelOf(scene.stage->mesh.toWorld(0, point));
  }

  Offscreen context_;
  Font font_;
  Renderer renderer_{kWidth, kHeight, font_};
  Camera camera_;
};

}  // namespace platon
