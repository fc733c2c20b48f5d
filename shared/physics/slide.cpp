#include "shared/physics/slide.h"

#include <algorithm>
#include <cstdlib>

#include "shared/exact/integer.h"

namespace platon {
namespace {

bool xDominates(Point vector) { return std::abs(std::int64_t{vector.x}) >= std::abs(std::int64_t{vector.y}); }

// `along` of the tangent's coordinate `tangent`, truncated. |along| < 2^62, |tangent| < 2^30, length < 2^61.
std::int64_t part(std::int64_t along, std::int32_t tangent, std::int64_t squaredLength) {
  return static_cast<std::int64_t>(int128{along} * tangent / squaredLength);
}

// The smallest v, in the direction of `normal`, with v * normal >= least.
std::int64_t outwards(std::int64_t least, std::int32_t normal) {
  return normal > 0 ? divideCeiling<std::int64_t>(least, normal) : -divideCeiling<std::int64_t>(least, -normal);
}

}  // namespace

Point slideAlong(Point displacement, Point normal) {
  const Point tangent = perpendicular(normal);
  const std::int64_t along = dot(displacement, tangent);
  const std::int64_t length = squaredLength(tangent);
  if (xDominates(tangent)) {
    const std::int64_t x = part(along, tangent.x, length);
    if (x == 0) return {};
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(outwards(-x * normal.x, normal.y))};
  }
  const std::int64_t y = part(along, tangent.y, length);
  if (y == 0) return {};
  return {static_cast<std::int32_t>(outwards(-y * normal.y, normal.x)), static_cast<std::int32_t>(y)};
}

Point turnedNormal(Point normal, Angle angle) {
  const WideVector turned = rotateWide(normal, directionOf(angle));
  std::int64_t x = turned.x;
  std::int64_t y = turned.y;
  while (std::max(std::abs(x), std::abs(y)) >= (std::int64_t{1} << 29)) {
    x = divideRounded<std::int64_t>(x, 2);
    y = divideRounded<std::int64_t>(y, 2);
  }
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

Point dominantStep(Point vector) {
  if (xDominates(vector)) return {vector.x > 0 ? 1 : -1, 0};
  return {0, vector.y > 0 ? 1 : -1};
}

}  // namespace platon
