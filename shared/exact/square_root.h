#pragma once

#include "shared/exact/integer.h"

namespace platon {

/// The largest integer whose square is at most `value`; 0 <= value < 2^124.
constexpr int128 squareRootFloor(int128 value) {
  int128 root = 0;
  for (int128 bit = int128{1} << 61; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return root;
}

}  // namespace platon
