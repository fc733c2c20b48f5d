#pragma once

#include <bit>
#include <cstdint>

#include "platon/exact/integer.h"

namespace platon {

/// The square root rounded down. Requires 0 <= value < 2^62 for 64-bit types, < 2^124 for 128-bit types.
template <class Integer>
constexpr Integer squareRootFloor(Integer value) {
  static_assert(sizeof(Integer) >= sizeof(std::int64_t));
  if (value == 0) return 0;
  const auto high = static_cast<std::uint64_t>(value >> 62);
  const int width =
      static_cast<int>(high != 0 ? 62 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(value)));
  // Newton's method, decreasing from above. The first step starts at a power of two below the root and needs no
  // division.
  const int below = (width - 1) / 2;
  Integer root = ((Integer{1} << below) + (value >> below)) / 2;
  for (;;) {
    const Integer next = (root + value / root) / 2;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace platon
