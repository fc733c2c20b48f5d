#pragma once

#include <bit>
#include <cstdint>

#include "platon/exact/integer.h"

namespace platon {

/// The largest integer whose square is at most `value`; 0 <= value < 2^124, with 64 bits 2^62.
template <class Integer>
constexpr Integer squareRootFloor(Integer value) {
  static_assert(sizeof(Integer) >= sizeof(std::int64_t));
  if (value == 0) return 0;
  const auto high = static_cast<std::uint64_t>(value >> 62);
  const int width =
      static_cast<int>(high != 0 ? 62 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(value)));
  // Newton's method: every root from here on is too large or the answer, and the next one smaller until it is that. The
  // first step, from the power of two below the answer, needs no division.
  const int below = (width - 1) / 2;
  Integer root = ((Integer{1} << below) + (value >> below)) / 2;
  for (;;) {
    const Integer next = (root + value / root) / 2;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace platon
