#include "client/scene/look_round.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/scene/camera_ease.h"

namespace platon {
namespace {

constexpr double kWholeAngle = 0.7;  // radians from which the whole solid is seen

}  // namespace

void LookRound::update(const LookInput& input, double seconds) {
  if (input.held) {
    angles_ += kSpeed * seconds * input.direction + input.turn;
    angles_.x = std::remainder(angles_.x, 2 * std::numbers::pi);
    angles_.y = std::clamp(angles_.y, -kMaxUp, kMaxUp);
    return;
  }
  const double length = glm::length(angles_);
  if (length > 0) angles_ *= leftAfter(length, kReturn, kMaxReturn, seconds) / length;
}

ViewPoint LookRound::turned(const ViewPoint& view, const SolidMesh& mesh) const {
  if (angles_ == glm::dvec2(0)) return view;
  const glm::dquat turn =
      glm::angleAxis(angles_.x, glm::dvec3(0, 1, 0)) * glm::angleAxis(-angles_.y, glm::dvec3(1, 0, 0));
  const double part = glm::smoothstep(0.0, kWholeAngle, glm::length(angles_));
  return drawnBack(mesh, glm::normalize(view.orientation * turn), view.fromCentre(), part);
}

}  // namespace platon
