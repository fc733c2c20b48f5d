#pragma once

#include <glm/vec2.hpp>

#include "levels/drawing/colour.h"

namespace platon {

/// A wall on a face: a strip with round ends, raised along the normal of the face. Level units in the frame of the
/// face.
struct Wall {
  static constexpr double kHeight = 12;  ///< of a segment

  glm::dvec2 a{0};
  glm::dvec2 b{0};
  double halfWidth = 2;
  double height = kHeight;
  Colour colour{1};
};

}  // namespace platon
