#include "client/audio/hearing.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace platon {

Heard hear(const Pose& listener, glm::dvec3 place) {
  const glm::dvec3 way = place - listener.position;
  const double distance = glm::length(way) / kHalfGainDistance;
  const double side = glm::dot(way, glm::cross(listener.up, listener.normal)) / kFullPanDistance;
  return {1 / (1 + distance * distance), std::clamp(side, -1.0, 1.0)};
}

}  // namespace platon
