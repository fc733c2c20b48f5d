#include "client/gl/background_painter.h"

#include <glm/mat4x4.hpp>

#include "client/gl/shaders.h"

namespace platon {
namespace {

constexpr GLsizei kStars = 900;
constexpr float kReferenceHeight = 720;  // picture height at which a star has its nominal size

}  // namespace

BackgroundPainter::BackgroundPainter()
    : dark_("", shaders::kBackgroundVertex, shaders::kBackgroundFragment),
      stars_("", shaders::kStarVertex, shaders::kStarFragment) {}

void BackgroundPainter::draw(const Camera& camera) {
  glBindVertexArray(array_.name());
  dark_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  stars_.use();
  stars_.set("toClip", glm::mat4(camera.viewProjection()));
  stars_.set("pixels", static_cast<float>(camera.height()) / kReferenceHeight);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, kStars);
}

}  // namespace platon
