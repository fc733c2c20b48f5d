#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "levels/drawing/solid_frame.h"

namespace platon {

/// Position and orientation in space: level units, origin at the solid's centre.
struct Pose {
  glm::dvec3 position{0, 0, 1};
  glm::dvec3 up{0, 1, 0};      ///< unit, along the face
  glm::dvec3 normal{0, 0, 1};  ///< unit, out of the face
};

/// Rotates `vector` by the smallest rotation that takes the unit normal `from` to `onto`. The normals must not be
/// opposite.
inline glm::dvec3 rotatedBetween(glm::dvec3 vector, glm::dvec3 from, glm::dvec3 onto) {
  return vector - (from + onto) * (glm::dot(onto, vector) / (1 + glm::dot(from, onto)));
}

}  // namespace platon
