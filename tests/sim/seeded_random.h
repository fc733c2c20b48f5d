#pragma once

#include <cstdint>

#include "platon/exact/point.h"

namespace platon::sim {

/// Seeded numbers that are the same everywhere (SplitMix64, Steele, Lea and Flood 2014).
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// In [0, bound); bound > 0. The bias is below 2^-32 for the bounds used here.
  std::uint64_t below(std::uint64_t bound) { return (next() >> 32) * bound >> 32; }
  /// A vector of length `most` at most, evenly spread over the disc. most < 2^28.
  Point vector(std::int32_t most) {
    for (;;) {
      const auto span = static_cast<std::uint64_t>(most) * 2 + 1;
      const auto y = static_cast<std::int32_t>(below(span)) - most;  // not as arguments: compilers differ in the order
      const Point point(static_cast<std::int32_t>(below(span)) - most, y);
      if (squaredLength(point) <= std::int64_t{most} * most) return point;
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace platon::sim
