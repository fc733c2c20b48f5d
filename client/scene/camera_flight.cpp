#include "client/scene/camera_flight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "client/scene/camera_ease.h"

namespace platon {

void CameraFlight::start(const ViewPoint& from) {
  from_ = from;
  progress_ = 0;
  speed_ = 1 / kSeconds;
}

void CameraFlight::skip() { speed_ = std::max(speed_, (1 - progress_) / kSkipSeconds); }

void CameraFlight::advance(double seconds) { progress_ = std::min(1.0, progress_ + speed_ * seconds); }

ViewPoint CameraFlight::towards(const ViewPoint& to, const SolidMesh& mesh) const {
  if (!flying()) return to;
  const double part = smootherstep(progress_);
  const glm::dquat orientation = glm::normalize(glm::slerp(from_.orientation, to.orientation, part));
  const glm::dvec3 fromCentre = glm::mix(from_.fromCentre(), to.fromCentre(), part);
  return drawnBack(mesh, orientation, fromCentre, 0.8 * std::sin(std::numbers::pi * part));
}

}  // namespace platon
