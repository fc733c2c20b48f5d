#pragma once

#include <cstdint>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// An angle in centidegrees (hundredths of a degree), counter-clockwise, always in [0, 36000). The turns between faces
/// of a Platonic solid (36°, 60°, 72°, 90°, …) are whole centidegrees, so orientation never drifts.
class Angle {
 public:
  static constexpr std::int32_t kTurn = 36000;

  constexpr Angle() = default;
  /// Accepts any number of centidegrees and reduces it modulo a whole turn.
  constexpr explicit Angle(std::int32_t centidegrees) : centidegrees_((centidegrees % kTurn + kTurn) % kTurn) {}
  static constexpr Angle degrees(std::int32_t degrees) { return Angle(degrees % 360 * 100); }

  /// In [0, 36000).
  constexpr std::int32_t centidegrees() const { return centidegrees_; }

  friend constexpr bool operator==(Angle, Angle) = default;
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.centidegrees_ + b.centidegrees_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.centidegrees_ - b.centidegrees_); }
  constexpr Angle operator-() const { return Angle(-centidegrees_); }

 private:
  std::int32_t centidegrees_ = 0;
};

/// Cosine and sine of an angle in fixed point with 30 fractional bits. Each is within 2^-29 of the true value, and
/// exact at multiples of a quarter turn.
struct Rotation {
  static constexpr int kFractionBits = 30;
  std::int64_t cosine = 0;
  std::int64_t sine = 0;

  /// The rotation by 0°.
  static constexpr Rotation none() { return {std::int64_t{1} << kFractionBits, 0}; }
  friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
};

/// Cosine and sine of `angle`, from integer tables.
Rotation rotationOf(Angle angle);

/// A vector in subunits with 30 fractional bits: the result of a rotation before rounding.
struct WideVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Rotates `vector` without rounding. Coordinates of `vector` below 2^31 give results below 2^62.
constexpr WideVector rotateWide(Point vector, Rotation rotation) {
  return {vector.x * rotation.cosine - vector.y * rotation.sine, vector.x * rotation.sine + vector.y * rotation.cosine};
}

/// Rotates `vector` and rounds to the nearest lattice point, halves away from zero. Rounding is symmetric:
/// rotate(-v) == -rotate(v).
constexpr Point rotate(Point vector, Rotation rotation) {
  const WideVector wide = rotateWide(vector, rotation);
  return {static_cast<std::int32_t>(shiftRounded<Rotation::kFractionBits>(wide.x)),
          static_cast<std::int32_t>(shiftRounded<Rotation::kFractionBits>(wide.y))};
}
Point rotate(Point vector, Angle angle);

/// The angle from vector `from` to vector `to`, rounded to the nearest centidegree. Neither vector may be zero.
Angle angleBetween(Point from, Point to);

}  // namespace platon
