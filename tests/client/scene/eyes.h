#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "levels/drawing/colour.h"

namespace platon {

inline glm::dvec3 linear(Colour colour) {
  glm::dvec3 result;
  for (int i = 0; i < 3; ++i)
    result[i] = colour[i] <= 0.04045F ? colour[i] / 12.92 : std::pow((colour[i] + 0.055) / 1.055, 2.4);
  return result;
}

inline double luminance(glm::dvec3 rgb) { return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// CIE lightness of a linear colour, 0 … 100.
inline double lightness(glm::dvec3 rgb) {
  const double y = luminance(rgb);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

/// A linear colour in CIE Lab with the white of sRGB: distances are about how different colours look.
inline glm::dvec3 lab(glm::dvec3 rgb) {
  const auto part = [](double share) { return share > 0.008856 ? std::cbrt(share) : (903.3 * share + 16) / 116; };
  const double x = part(glm::dot(rgb, glm::dvec3(0.4124, 0.3576, 0.1805)) / 0.9505);
  const double y = part(luminance(rgb));
  const double z = part(glm::dot(rgb, glm::dvec3(0.0193, 0.1192, 0.9505)) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Linear colours as eyes see them that lack red or green cones: Viénot, Brettel and Mollon, 1999.
inline glm::dvec3 protanope(glm::dvec3 c) {
  const double mixed = 0.11238 * c.r + 0.88762 * c.g;
  return {mixed, mixed, 0.00401 * c.r - 0.00401 * c.g + c.b};
}
inline glm::dvec3 deuteranope(glm::dvec3 c) {
  const double mixed = 0.29275 * c.r + 0.70725 * c.g;
  return {mixed, mixed, -0.02234 * c.r + 0.02234 * c.g + c.b};
}

}  // namespace platon
