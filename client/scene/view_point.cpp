#include "client/scene/view_point.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"

namespace platon {
namespace {

constexpr double kClearance = 90;  // smallest height of the eye above the faces, level units

}  // namespace

ViewPoint drawnBack(const SolidMesh& mesh, glm::dquat orientation, glm::dvec3 fromCentre, double part) {
  const glm::dvec3 away(0, 0, std::max(fromCentre.z, CameraTarget::kWholeSolid * mesh.circumradius()));
  const glm::dvec3 eye = orientation * glm::mix(fromCentre, away, part);
  const double height = glm::dot(mesh.normal(mesh.faceTowards(eye)), eye);
  return {orientation, eye * std::max(1.0, (mesh.inradius() + kClearance) / height)};
}

double angleOfTurn(const glm::dquat& turn) {
  return 2 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), turn.w);
}

glm::dquat partOf(const glm::dquat& turn, double part) {
  const glm::dvec3 axis(turn.x, turn.y, turn.z);
  if (glm::length(axis) < 1e-15) return {1, 0, 0, 0};
  return glm::angleAxis(part * angleOfTurn(turn), glm::normalize(axis));
}

double leftAfter(double distance, double rate, double maxSpeed, double seconds) {
  const double beyond = std::max(0.0, distance - maxSpeed / rate);
  const double straight = std::min(seconds, beyond / maxSpeed);
  return (distance - maxSpeed * straight) * std::exp(-rate * (seconds - straight));
}

double smootherstep(double part) { return part * part * part * (part * (6 * part - 15) + 10); }

}  // namespace platon
