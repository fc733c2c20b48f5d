#pragma once

// Before all else, so that nothing that such a target lacks as well hides it.
#if !defined(__SIZEOF_INT128__)
#error "Platon compares fractions through 128-bit integers, which GCC and Clang have for 64-bit targets and wasm32"
#endif

#include <concepts>
#include <cstdint>

namespace platon {

/// The integers of one width on every machine: what may be hashed or saved. Neither `char`, whose sign differs between
/// machines, nor `std::size_t` where it has 32 bits.
template <class Integer>
concept FixedInteger = std::same_as<Integer, bool> || std::same_as<Integer, std::int8_t> ||
    std::same_as<Integer, std::uint8_t> || std::same_as<Integer, std::int16_t> ||
    std::same_as<Integer, std::uint16_t> || std::same_as<Integer, std::int32_t> ||
    std::same_as<Integer, std::uint32_t> || std::same_as<Integer, std::int64_t> || std::same_as<Integer, std::uint64_t>;

/// Wide enough for the product of any two `int64` values. Never stored, hashed or sent: its alignment differs
/// between machines.
__extension__ using int128 = __int128;

/// Subunits in one level unit. All coordinates of the simulation are whole subunits.
inline constexpr std::int32_t kSubunitsPerUnit = 1024;

/// Every coordinate and every displacement of the simulation is smaller than this in magnitude.
inline constexpr std::int32_t kCoordinateLimit = std::int32_t{1} << 29;

/// True when `value` may be a coordinate.
constexpr bool isCoordinate(std::int64_t value) { return value > -kCoordinateLimit && value < kCoordinateLimit; }

/// `numerator / denominator` rounded to the nearest integer, halves away from zero, so that the rounding of -x is
/// minus the rounding of x. `denominator` > 0 and the quotient must fit.
template <class Integer>
constexpr Integer divideRounded(Integer numerator, Integer denominator) {
  const Integer half = denominator / 2;
  return numerator >= 0 ? (numerator + half) / denominator : -((-numerator + half) / denominator);
}

/// The same for a denominator of 2^bits, 0 < bits < 62; |value| < 2^62.
template <int bits>
constexpr std::int64_t shiftRounded(std::int64_t value) {
  constexpr std::int64_t half = std::int64_t{1} << (bits - 1);
  return (value + half - (value < 0 ? 1 : 0)) >> bits;  // of halves below 0, which the shift rounds up, one less
}

/// `value * factor / divisor` rounded towards zero; `divisor` > 0 and the quotient must fit.
constexpr std::int64_t scaleTruncated(std::int64_t value, std::int64_t factor, std::int64_t divisor) {
  const int128 product = int128{value} * factor;
  const auto low = static_cast<std::int64_t>(product);
  if (low == product) return low / divisor;  // far quicker, and mostly so
  return static_cast<std::int64_t>(product / divisor);
}

/// `numerator / denominator` rounded towards minus infinity. `denominator` > 0.
template <class Integer>
constexpr Integer divideFloor(Integer numerator, Integer denominator) {
  const Integer quotient = numerator / denominator;
  return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// `numerator / denominator` rounded towards plus infinity. `denominator` > 0.
template <class Integer>
constexpr Integer divideCeiling(Integer numerator, Integer denominator) {
  const Integer quotient = numerator / denominator;
  return numerator % denominator > 0 ? quotient + 1 : quotient;
}

}  // namespace platon
