#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/exactness/oracle/random_source.h"

namespace platon::properties {

/// Seed of the first case: the value of the environment variable PLATON_SEED, or 1. A failure names the seed of its
/// case; set PLATON_SEED to it to run that case first.
inline std::uint64_t firstSeed() {
  const char* given = std::getenv("PLATON_SEED");
  return given == nullptr ? 1 : std::strtoull(given, nullptr, 10);
}

/// Calls `check` with `count` differently seeded random sources. Stops at the first failure.
template <class Check>
void forEachCase(std::int64_t count, Check&& check) {
  const std::uint64_t first = firstSeed();
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    SCOPED_TRACE("PLATON_SEED=" + std::to_string(seed));
    oracle::RandomSource random(seed);
    check(random);
    if (testing::Test::HasFailure()) return;
  }
}

/// A random integer of magnitude `limit` or less, often an edge case of arithmetic: 0, 1, the limits, powers of two and
/// their neighbours. Requires limit < 2^63.
inline std::int64_t anyInteger(oracle::RandomSource& random, std::int64_t limit) {
  const auto within = [limit](std::int64_t value) { return value > limit ? limit : value < -limit ? -limit : value; };
  const std::int64_t sign = random.oneIn(2) ? 1 : -1;
  switch (random.below(5)) {
    case 0:
      return random.between(-1, 1);
    case 1:
      return sign * (limit - random.between(0, limit < 2 ? limit : 2));
    case 2:
      return within(sign * ((std::int64_t{1} << random.between(0, 61)) + random.between(-1, 1)));
    case 3:
      return within(random.between(-1000, 1000));
    default:
      return sign * random.between(0, limit);
  }
}

}  // namespace platon::properties
