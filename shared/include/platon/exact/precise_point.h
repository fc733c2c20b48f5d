#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A position in 65 536ths of a subunit, for what has to be known better than it can be placed.
struct PrecisePoint {
  static constexpr int kBits = 16;
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;

  std::int64_t x = 0;
  std::int64_t y = 0;

  friend constexpr bool operator==(const PrecisePoint&, const PrecisePoint&) = default;
};

constexpr PrecisePoint precise(Point point) { return {point.x * PrecisePoint::kOne, point.y * PrecisePoint::kOne}; }

constexpr PrecisePoint operator+(PrecisePoint a, PrecisePoint b) { return {a.x + b.x, a.y + b.y}; }
constexpr PrecisePoint operator-(PrecisePoint a, PrecisePoint b) { return {a.x - b.x, a.y - b.y}; }

/// The nearest whole point, halves away from zero. The coordinates must fit.
constexpr Point rounded(PrecisePoint point) {
  return {static_cast<std::int32_t>(shiftRounded<PrecisePoint::kBits>(point.x)),
          static_cast<std::int32_t>(shiftRounded<PrecisePoint::kBits>(point.y))};
}

/// `vector` turned. |vector| < 2^31 a coordinate.
constexpr PrecisePoint rotatePrecise(Point vector, Rotation direction) {
  constexpr int bits = Rotation::kFractionBits - PrecisePoint::kBits;
  const WideVector turned = rotateWide(vector, direction);
  return {shiftRounded<bits>(turned.x), shiftRounded<bits>(turned.y)};
}

/// Half way between two points, exactly.
constexpr PrecisePoint middle(Point a, Point b) {
  return {(std::int64_t{a.x} + b.x) * (PrecisePoint::kOne / 2), (std::int64_t{a.y} + b.y) * (PrecisePoint::kOne / 2)};
}

}  // namespace platon
