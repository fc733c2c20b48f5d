#pragma once

#include <algorithm>
#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A position or displacement in subunits with 26 fractional bits, for values that must be finer than the lattice.
struct PrecisePoint {
  static constexpr int kBits = 26;
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;

  std::int64_t x = 0;
  std::int64_t y = 0;

  friend constexpr bool operator==(const PrecisePoint&, const PrecisePoint&) = default;
};

/// The lattice point `point` as a PrecisePoint; exact.
constexpr PrecisePoint precise(Point point) { return {point.x * PrecisePoint::kOne, point.y * PrecisePoint::kOne}; }

constexpr PrecisePoint operator+(PrecisePoint a, PrecisePoint b) { return {a.x + b.x, a.y + b.y}; }
constexpr PrecisePoint operator-(PrecisePoint a, PrecisePoint b) { return {a.x - b.x, a.y - b.y}; }

constexpr PrecisePoint operator-(PrecisePoint a) { return {-a.x, -a.y}; }

/// The larger of |x| and |y|.
constexpr std::int64_t maxNorm(PrecisePoint a) { return std::max(a.x < 0 ? -a.x : a.x, a.y < 0 ? -a.y : a.y); }

/// The nearest lattice point, halves away from zero. The result must fit `int32`.
constexpr Point rounded(PrecisePoint point) {
  return {static_cast<std::int32_t>(shiftRounded<PrecisePoint::kBits>(point.x)),
          static_cast<std::int32_t>(shiftRounded<PrecisePoint::kBits>(point.y))};
}

/// Rotates `vector` and rounds to 26 fractional bits. Requires |vector| < 2^31 per coordinate.
constexpr PrecisePoint rotatePrecise(Point vector, Rotation rotation) {
  constexpr int bits = Rotation::kFractionBits - PrecisePoint::kBits;
  const WideVector turned = rotateWide(vector, rotation);
  return {shiftRounded<bits>(turned.x), shiftRounded<bits>(turned.y)};
}

/// Rotates `vector`, rounded to 26 fractional bits. Requires |vector| < 2^60 per coordinate.
constexpr PrecisePoint rotated(PrecisePoint vector, Rotation rotation) {
  constexpr int128 one = int128{1} << Rotation::kFractionBits;
  const int128 x = int128{vector.x} * rotation.cosine - int128{vector.y} * rotation.sine;
  const int128 y = int128{vector.x} * rotation.sine + int128{vector.y} * rotation.cosine;
  return {static_cast<std::int64_t>(divideRounded(x, one)), static_cast<std::int64_t>(divideRounded(y, one))};
}

/// The exact midpoint of `a` and `b`.
constexpr PrecisePoint middle(Point a, Point b) {
  return {(std::int64_t{a.x} + b.x) * (PrecisePoint::kOne / 2), (std::int64_t{a.y} + b.y) * (PrecisePoint::kOne / 2)};
}

}  // namespace platon
