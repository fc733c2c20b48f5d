#include "client/gl/paint/beam_painter.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "client/gl/gl_objects.h"

namespace platon {
namespace {

constexpr double kLength = 1.3;  // in circumradii of the solid
constexpr double kRadius = StageModel::kGoalRadius;
constexpr float kAlpha = 0.55F;
constexpr float kHiddenAlpha = 0.55F;
const Colour kLight(1.0F, 0.84F, 0.36F);  // as the ring of the goal

glm::dvec3 footOf(const StageModel& stage) { return stage.mesh.toWorld(stage.goal.face, glm::dvec2(stage.goal.place)); }

// The part of the way from the foot of the beam to its tip that is behind the solid: 0 … 1, from the foot.
double hiddenPart(const SolidMesh& mesh, glm::dvec3 eye, glm::dvec3 foot, glm::dvec3 way) {
  if (!mesh.isBetween(eye, foot)) return 0;
  double hidden = 0;
  double seen = 1;
  for (int step = 0; step < 12; ++step) {
    const double middle = (hidden + seen) / 2;
    (mesh.isBetween(eye, foot + way * middle) ? hidden : seen) = middle;
  }
  return hidden;
}

}  // namespace

void BeamPainter::draw(const StageModel& stage, const Camera& camera, float strength, float seconds) {
  const SolidMesh& mesh = stage.mesh;
  const glm::dvec3 foot = footOf(stage);
  const glm::dvec3 normal = mesh.normal(stage.goal.face);
  const glm::dvec3 toEye = glm::normalize(camera.eye() - foot);
  const glm::dvec3 across = glm::cross(normal, toEye);
  const double sine = glm::length(across);  // of the angle between beam and line of sight
  if (sine < 0.02) return;
  const double length = kLength * mesh.circumradius();
  glBindVertexArray(array_.name());
  glDepthMask(GL_FALSE);
  const auto fade = static_cast<float>(std::clamp(sine * 1.6 - 0.25, 0.0, 1.0));
  beam_.use();
  beam_.set("toClip", glm::mat4(camera.viewProjection()));
  beam_.set("foot", glm::vec3(foot));
  beam_.set("way", glm::vec3(normal * length));
  beam_.set("aside", glm::vec3(across * (kRadius / sine)));
  beam_.set("tilt", static_cast<float>(kRadius * std::abs(glm::dot(normal, toEye)) / (length * sine)));
  beam_.set("seconds", seconds);
  beam_.set("hidden", false);
  beam_.set("colour", glm::vec4(kLight, kAlpha * fade * strength));
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  if (const double part = hiddenPart(mesh, camera.eye(), foot, normal * length); part > 0) {
    beam_.set("hidden", true);
    beam_.set("hiddenPart", static_cast<float>(part));
    beam_.set("colour", glm::vec4(kLight, kHiddenAlpha * std::min(strength, 1.0F)));
    glDepthFunc(GL_GREATER);
    DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
    glDepthFunc(GL_LEQUAL);
  }
  glDepthMask(GL_TRUE);
}

}  // namespace platon
