#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// Seeded random numbers that do not depend on the standard library.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// low … high, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// True with probability 1 / `count`.
  bool oneIn(std::int64_t count) { return between(1, count) == 1; }
  /// An index below `count`.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  /// Each component -radius … radius.
  Vec vector(std::int64_t radius) { return {between(-radius, radius), between(-radius, radius)}; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace platon::oracle
