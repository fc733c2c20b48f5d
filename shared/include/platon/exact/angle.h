#pragma once

#include <cstdint>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// An orientation in centidegrees, counter-clockwise, always in [0, 36000). Every turn between faces of a
/// Platonic solid (36°, 60°, 72°, 90°, …) is exact, so that orientation never drifts.
class Angle {
 public:
  static constexpr std::int32_t kTurn = 36000;

  constexpr Angle() = default;
  /// Any count of centidegrees; whole turns are taken off.
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

/// Cosine and sine as integers over 2^30; each is within 2^-29 of the true value and exact at every quarter turn.
struct Rotation {
  static constexpr int kFractionBits = 30;
  std::int64_t cosine = 0;
  std::int64_t sine = 0;

  /// That of no turn: what it turns stays as it is.
  static constexpr Rotation none() { return {std::int64_t{1} << kFractionBits, 0}; }
  friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
};

/// The direction of an angle, from an integer table.
Rotation rotationOf(Angle angle);

/// A vector in 64 bits, scaled by 2^30: what an exact-table rotation gives before it is rounded.
struct WideVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// `vector` turned by `direction`, over 2^30, unrounded. |vector| < 2^31 a coordinate keeps it below 2^62.
constexpr WideVector rotateWide(Point vector, Rotation direction) {
  return {vector.x * direction.cosine - vector.y * direction.sine,
          vector.x * direction.sine + vector.y * direction.cosine};
}

/// `vector` turned by `direction`, rounded to the nearest whole vector, halves away from zero: turning by half a turn
/// first or last gives the same.
constexpr Point rotate(Point vector, Rotation direction) {
  const WideVector wide = rotateWide(vector, direction);
  return {static_cast<std::int32_t>(shiftRounded<Rotation::kFractionBits>(wide.x)),
          static_cast<std::int32_t>(shiftRounded<Rotation::kFractionBits>(wide.y))};
}
Point rotate(Point vector, Angle angle);

/// The angle that turns `from` into the direction of `to`, to the nearest centidegree. Neither is zero.
Angle angleBetween(Point from, Point to);

}  // namespace platon
