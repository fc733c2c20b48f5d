#include "client/gl/paint/sky_painter.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/gl_objects.h"

namespace platon {
namespace {

constexpr GLsizei kMotes = 220;
constexpr float kReferenceHeight = 720;  // picture height at which a mote has its nominal size
constexpr double kPeriod = 3000;         // seconds after which the motes are where they were, about

}  // namespace

SkyPainter::SkyPainter() : sky_("sky"), motes_("mote") {}

// A copy costs a tenth of the time that the shader takes.
void SkyPainter::prepare(const Scheme& scheme, std::uint32_t width, std::uint32_t height) {
  const Appearance appearance{scheme.skyTop, scheme.skyBottom, scheme.glow, width, height};
  if (appearance == painted_) return;
  painted_ = appearance;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  attachColour(colour_, width, height);
  glViewport(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
  glDisable(GL_BLEND);
  glBindVertexArray(array_.name());
  sky_.use();
  sky_.set("top", appearance.top);
  sky_.set("bottom", appearance.bottom);
  sky_.set("glow", appearance.glow);
  DrawCalls::arrays(GL_TRIANGLES, 3);
}

void SkyPainter::drawSky() const {
  const auto width = static_cast<GLint>(painted_.width);
  const auto height = static_cast<GLint>(painted_.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  DrawCalls::blit(width, height, width, height, GL_NEAREST);
}

void SkyPainter::drawMotes(const Scheme& scheme, const Camera& camera, double radius, double seconds) {
  glBindVertexArray(array_.name());
  motes_.use();
  motes_.set("toClip", glm::mat4(camera.viewProjection() * glm::scale(glm::dmat4(1), glm::dvec3(radius))));
  const double scale = glm::length(camera.eye()) * camera.height();
  motes_.set("pixels", static_cast<float>(scale) / kReferenceHeight);
  motes_.set("seconds", static_cast<float>(std::fmod(seconds, kPeriod)));
  motes_.set("colour", scheme.mote);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDepthMask(GL_FALSE);
  DrawCalls::arrays(GL_POINTS, kMotes);
  glDepthMask(GL_TRUE);
}

}  // namespace platon
