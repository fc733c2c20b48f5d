#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// Number of borders below `coordinate`: the number of the slice that holds it. A border belongs to the slice below it.
inline std::size_t bordersBelow(const std::vector<std::int32_t>& borders, std::int64_t coordinate) {
  return static_cast<std::size_t>(std::lower_bound(borders.begin(), borders.end(), coordinate) - borders.begin());
}

struct CoordinateRange {
  std::int64_t low, high;
};

/// The x range of segment ab, with a.y <= b.y, for y in [low, high], rounded outwards. Bounds: differences < 2^30,
/// products < 2^60.
inline CoordinateRange xRange(Point a, Point b, std::int64_t low, std::int64_t high) {
  if (a.y == b.y) return {std::min(a.x, b.x), std::max(a.x, b.x)};
  const std::int64_t width = std::int64_t{b.x} - a.x;
  const std::int64_t height = std::int64_t{b.y} - a.y;
  const std::int64_t atLow = width * (low - a.y);
  const std::int64_t atHigh = width * (high - a.y);
  return {a.x + divideFloor(std::min(atLow, atHigh), height), a.x + divideCeiling(std::max(atLow, atHigh), height)};
}

}  // namespace platon
