#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platon/exact/point.h"

namespace platon {

/// Number of lattice points within kRadius of the origin.
template <std::int32_t kRadius>
constexpr std::size_t latticeDiscSize() {
  std::size_t count = 0;
  for (std::int32_t y = -kRadius; y <= kRadius; ++y) {
    for (std::int32_t x = -kRadius; x <= kRadius; ++x) count += x * x + y * y <= kRadius * kRadius;
  }
  return count;
}

/// The lattice points within kRadius of the origin, nearest first; points at equal distance are ordered by y, then x.
template <std::int32_t kRadius>
constexpr std::array<Point, latticeDiscSize<kRadius>()> latticeDisc() {
  std::array<Point, latticeDiscSize<kRadius>()> disc{};
  std::size_t count = 0;
  for (std::int32_t squared = 0; squared <= kRadius * kRadius; ++squared) {
    for (std::int32_t y = -kRadius; y <= kRadius; ++y) {
      for (std::int32_t x = -kRadius; x <= kRadius; ++x) {
        if (x * x + y * y == squared) disc[count++] = Point(x, y);
      }
    }
  }
  return disc;
}

}  // namespace platon
