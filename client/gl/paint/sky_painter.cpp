#include "client/gl/paint/sky_painter.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/draw_calls.h"

namespace platon {
namespace {

constexpr GLsizei kMotes = 220;
constexpr float kReferenceHeight = 720;  // picture height at which a mote has its nominal size
constexpr double kPeriod = 3000;         // seconds after which the motes are where they were, about

}  // namespace

SkyPainter::SkyPainter() : sky_("sky"), motes_("mote") {}

void SkyPainter::drawSky(const Scheme& scheme) {
  glBindVertexArray(array_.name());
  sky_.use();
  sky_.set("top", scheme.skyTop);
  sky_.set("bottom", scheme.skyBottom);
  sky_.set("glow", scheme.glow);
  DrawCalls::arrays(GL_TRIANGLES, 3);
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
