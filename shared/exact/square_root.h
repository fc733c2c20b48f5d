#pragma once

#include <cstdint>

#include "shared/exact/integer.h"

namespace platon {

/// The largest integer whose square is at most `value`; 0 <= value < 2^124, with 64 bits 2^62.
template <class Integer>
constexpr Integer squareRootFloor(Integer value) {
  constexpr int kHighest = sizeof(Integer) == sizeof(int128) ? 61 : 30;
  static_assert(sizeof(Integer) >= sizeof(std::int64_t));
  Integer root = 0;
  for (int bit = kHighest; bit >= 0; --bit) {
    const Integer next = root + (Integer{1} << bit);
    if (next * next <= value) root = next;
  }
  return root;
}

}  // namespace platon
