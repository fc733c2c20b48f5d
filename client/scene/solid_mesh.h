#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
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

/// The solid of the scene: its faces in space, the poses on them, and the points of its surface.
class SolidMesh : public SolidFrame {
 public:
  using SolidFrame::SolidFrame;

  /// The pose at `point` of a face whose up is the face's +y rotated by `angle`, radians counter-clockwise.
  Pose pose(int face, glm::dvec2 point, double angle) const;
  /// The face that the ray from the centre through `point` intersects. `point` is not the centre.
  int faceTowards(glm::dvec3 point) const;
  /// Projects `point` from the centre onto the surface. `point` is not the centre.
  glm::dvec3 onSurface(glm::dvec3 point) const;
  /// Whether the solid is between a point outside it and one that is outside it or on its surface.
  bool isBetween(glm::dvec3 a, glm::dvec3 b) const;
};

}  // namespace platon
