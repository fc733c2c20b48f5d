#pragma once

// Checked before any include, so that this message is the first error on an unsupported target.
#if !defined(__SIZEOF_INT128__)
#error "Platon needs 128-bit integers: compile with GCC or Clang for a 64-bit target or wasm32"
#endif

#include <concepts>
#include <cstdint>

namespace platon {

/// The integer types that may be hashed and saved: those with the same width and signedness on every platform. Excludes
/// `bool`, `char` (its signedness differs) and `std::size_t` where it is a type of its own (its width differs).
template <class Integer>
concept FixedInteger =
    std::same_as<Integer, std::int8_t> || std::same_as<Integer, std::uint8_t> || std::same_as<Integer, std::int16_t> ||
    std::same_as<Integer, std::uint16_t> || std::same_as<Integer, std::int32_t> ||
    std::same_as<Integer, std::uint32_t> || std::same_as<Integer, std::int64_t> || std::same_as<Integer, std::uint64_t>;

/// Holds the product of any two `int64` values. Used for intermediate results only; never stored, hashed or sent,
/// because its alignment differs between platforms.
__extension__ using int128 = __int128;

/// Subunits per level unit. All coordinates of the simulation are whole subunits.
inline constexpr std::int32_t kSubunitsPerUnit = 1024;

/// Coordinates and displacements are below this limit in magnitude.
inline constexpr std::int32_t kCoordinateLimit = std::int32_t{1} << 29;

/// Whether `value` is in the range of coordinates.
constexpr bool isCoordinate(std::int64_t value) { return value > -kCoordinateLimit && value < kCoordinateLimit; }

/// `numerator / denominator` rounded to the nearest integer, halves away from zero. Symmetric: divideRounded(-n, d) ==
/// -divideRounded(n, d). Requires denominator > 0 and |numerator| + denominator / 2 within the type.
template <class Integer>
constexpr Integer divideRounded(Integer numerator, Integer denominator) {
  const Integer half = denominator / 2;
  return numerator >= 0 ? (numerator + half) / denominator : -((-numerator + half) / denominator);
}

/// `value / 2^bits` rounded like divideRounded. Requires 0 < bits < 62 and |value| < 2^62.
template <int bits>
constexpr std::int64_t shiftRounded(std::int64_t value) {
  constexpr std::int64_t half = std::int64_t{1} << (bits - 1);
  return (value + half - (value < 0 ? 1 : 0)) >> bits;  // the shift rounds towards minus infinity
}

/// `value * factor / divisor` rounded towards zero. Requires divisor > 0 and a quotient that fits 64 bits.
constexpr std::int64_t scaleTruncated(std::int64_t value, std::int64_t factor, std::int64_t divisor) {
  const int128 product = int128{value} * factor;
  const auto low = static_cast<std::int64_t>(product);
  if (low == product) return low / divisor;  // fast path: the product usually fits 64 bits
  return static_cast<std::int64_t>(product / divisor);
}

/// `numerator / denominator` rounded towards minus infinity. Requires denominator > 0.
template <class Integer>
constexpr Integer divideFloor(Integer numerator, Integer denominator) {
  const Integer quotient = numerator / denominator;
  return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// `numerator / denominator` rounded towards plus infinity. Requires denominator > 0.
template <class Integer>
constexpr Integer divideCeiling(Integer numerator, Integer denominator) {
  const Integer quotient = numerator / denominator;
  return numerator % denominator > 0 ? quotient + 1 : quotient;
}

}  // namespace platon
