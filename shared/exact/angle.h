#pragma once

#include <cstdint>

#include "shared/exact/integer.h"
#include "shared/exact/point.h"

namespace platon {

/// An orientation in hundredths of a degree, counter-clockwise, always in [0, 36000). Every turn between faces of a
/// Platonic solid (36°, 60°, 72°, 90°, …) is exact, so that orientation never drifts.
class Angle {
 public:
  static constexpr std::int32_t kTurn = 36000;

  constexpr Angle() = default;
  /// Any count of hundredths of a degree; whole turns are taken off.
  constexpr explicit Angle(std::int32_t hundredths)
      : hundredths_((hundredths % kTurn + kTurn) % kTurn) {}
  static constexpr Angle degrees(std::int32_t degrees) { return Angle(degrees % 360 * 100); }

  /// In [0, 36000).
  constexpr std::int32_t hundredths() const { return hundredths_; }

  friend constexpr bool operator==(Angle, Angle) = default;
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.hundredths_ + b.hundredths_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.hundredths_ - b.hundredths_); }
  constexpr Angle operator-() const { return Angle(-hundredths_); }

 private:
  std::int32_t hundredths_ = 0;
};

/// Cosine and sine as integers over 2^30; each is within 2^-29 of the true value and exact at every quarter turn.
struct Direction {
  static constexpr int kFractionBits = 30;
  std::int64_t cosine = 0;
  std::int64_t sine = 0;

  /// That of no turn: what it turns stays as it is.
  static constexpr Direction none() { return {std::int64_t{1} << kFractionBits, 0}; }
  friend constexpr bool operator==(const Direction&, const Direction&) = default;
};

/// The direction of an angle, from an integer table.
Direction directionOf(Angle angle);

/// A vector in 64 bits, scaled by 2^30: what an exact-table rotation gives before it is rounded.
struct WideVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// `vector` turned by `direction`, over 2^30, unrounded. |vector| < 2^31 a coordinate keeps it below 2^62.
constexpr WideVector rotateWide(Point vector, Direction direction) {
  return {vector.x * direction.cosine - vector.y * direction.sine,
          vector.x * direction.sine + vector.y * direction.cosine};
}

/// `vector` turned by `direction`, rounded to the nearest whole vector, halves away from zero: turning by half a turn
/// first or last gives the same.
constexpr Point rotate(Point vector, Direction direction) {
  const WideVector wide = rotateWide(vector, direction);
  return {static_cast<std::int32_t>(shiftRounded<Direction::kFractionBits>(wide.x)),
          static_cast<std::int32_t>(shiftRounded<Direction::kFractionBits>(wide.y))};
}
Point rotate(Point vector, Angle angle);

/// The angle that turns `from` into the direction of `to`, to the nearest hundredth of a degree. Neither is zero.
Angle angleBetween(Point from, Point to);

}  // namespace platon
