#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// Number of borders below `coordinate`: the number of the slice that holds it. A border belongs to the slice below it.
/// Without branches, which nobody could predict: they took 4 % of a step.
inline std::size_t bordersBelow(const std::vector<std::int32_t>& borders, std::int64_t coordinate) {
  const std::int32_t* first = borders.data();
  std::size_t left = borders.size();
  while (left > 1) {
    const std::size_t half = left / 2;
    first += static_cast<std::size_t>(first[half - 1] < coordinate) * half;
    left -= half;
  }
  return static_cast<std::size_t>(first - borders.data()) + static_cast<std::size_t>(left == 1 && *first < coordinate);
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
