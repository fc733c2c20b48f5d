#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace platon {

/// A linear map of a plane into a picture, whose y points down.
struct PlaneMap {
  glm::dvec2 x{1, 0};       ///< what one unit along x of the plane becomes
  glm::dvec2 y{0, 1};       ///< the same along y
  glm::dvec2 origin{0, 0};  ///< where the origin of the plane lies in the picture

  glm::dvec2 operator()(glm::dvec2 point) const { return origin + x * point.x + y * point.y; }
};

/// The map of a plane whose own y points up: the first two columns and the last one of `matrix`, and +y upwards.
inline PlaneMap upright(const glm::dmat4& matrix) {
  const auto seen = [](const glm::dvec4& vector) { return glm::dvec2(vector.x, -vector.y); };
  return {seen(matrix[0]), seen(matrix[1]), seen(matrix[3])};
}

/// Moves and scales `map`, a map into another picture.
inline PlaneMap placed(const PlaneMap& map, glm::dvec2 origin, double scale) {
  return {scale * map.x, scale * map.y, origin + scale * map.origin};
}

}  // namespace platon
