#pragma once

#include <compare>
#include <cstdint>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// An exact quotient of two 64-bit integers with a positive denominator. Fractions are not reduced to lowest terms;
/// comparison is by value.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  friend constexpr bool operator==(Fraction a, Fraction b) {
    return int128{a.numerator} * b.denominator == int128{b.numerator} * a.denominator;
  }
  friend constexpr std::strong_ordering operator<=>(Fraction a, Fraction b) {
    const int128 left = int128{a.numerator} * b.denominator;
    const int128 right = int128{b.numerator} * a.denominator;
    return left < right   ? std::strong_ordering::less
           : left > right ? std::strong_ordering::greater
                          : std::strong_ordering::equal;
  }
};

/// `value * fraction` rounded towards zero. Requires -1 <= fraction <= 1.
constexpr std::int32_t scaleTruncated(std::int32_t value, Fraction fraction) {
  return static_cast<std::int32_t>(scaleTruncated(value, fraction.numerator, fraction.denominator));
}

/// `displacement * time` with both coordinates rounded towards zero. Requires 0 <= time <= 1.
constexpr Point scaleTruncated(Point displacement, Fraction time) {
  if (time.numerator == 0) return {};  // fast path: the shape usually touches the segment already
  return {scaleTruncated(displacement.x, time), scaleTruncated(displacement.y, time)};
}

}  // namespace platon
