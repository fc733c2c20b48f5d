#include "client/gl/paint/beam_painter.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "client/gl/draw_calls.h"

namespace platon {
namespace {

constexpr double kLength = 1.3;  // in circumradii of the solid
constexpr float kAlpha = 0.42F;
constexpr float kHiddenAlpha = 0.30F;
const Colour kLight(1.0F, 0.86F, 0.50F);

}  // namespace

BeamPainter::BeamPainter() : program_("beam") {}

void BeamPainter::draw(const StageModel& stage, const Camera& camera, float strength) {
  const SolidMesh& mesh = stage.mesh;
  const glm::dvec3 foot = mesh.toWorld(stage.goal.face, glm::dvec2(stage.goal.place));
  const glm::dvec3 normal = mesh.normal(stage.goal.face);
  const glm::dvec3 across = glm::cross(normal, glm::normalize(camera.eye() - foot));
  const double sine = glm::length(across);  // of the angle between beam and line of sight
  if (sine < 0.02) return;
  const auto fade = static_cast<float>(std::clamp(sine * 1.6 - 0.25, 0.0, 1.0));
  program_.use();
  program_.set("toClip", glm::mat4(camera.viewProjection()));
  program_.set("foot", glm::vec3(foot));
  program_.set("way", glm::vec3(normal * (kLength * mesh.circumradius())));
  program_.set("aside", glm::vec3(across * (StageModel::kGoalRadius / sine)));
  glBindVertexArray(array_.name());
  glDepthMask(GL_FALSE);
  program_.set("colour", glm::vec4(kLight, kAlpha * fade * strength));
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  // What the solid hides is seen almost along the beam: it is drawn wider.
  program_.set("aside", glm::vec3(across * (2 * StageModel::kGoalRadius / sine)));
  program_.set("colour", glm::vec4(kLight, kHiddenAlpha * strength));
  glDepthFunc(GL_GREATER);
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
}

}  // namespace platon
