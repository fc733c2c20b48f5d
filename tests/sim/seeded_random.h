#pragma once

#include <cstdint>

#include "platon/exact/point.h"

namespace platon::sim {

/// Pseudo-random numbers that depend only on the seed, on every machine (SplitMix64, Steele, Lea and Flood 2014).
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
  /// A number in [0, bound), bound > 0. The bias is below 2^-32 for the bounds used here.
  std::uint64_t below(std::uint64_t bound) { return (next() >> 32) * bound >> 32; }
  /// A vector uniformly distributed over the disc of radius `maxLength` < 2^28.
  Point vector(std::int32_t maxLength) {
    for (;;) {
      const auto span = static_cast<std::uint64_t>(maxLength) * 2 + 1;
      // Drawn in a separate statement: the order in which arguments are evaluated depends on the compiler.
      const auto y = static_cast<std::int32_t>(below(span)) - maxLength;
      const Point point(static_cast<std::int32_t>(below(span)) - maxLength, y);
      if (squaredLength(point) <= std::int64_t{maxLength} * maxLength) return point;
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace platon::sim
