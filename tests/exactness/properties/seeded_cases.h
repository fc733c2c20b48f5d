#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/exactness/oracle/random_source.h"

namespace platon::properties {

/// Seed of the first case: 1, or what the environment variable PLATON_SEED says. A failure names the seed of its own
/// case, which that variable makes the first.
inline std::uint64_t firstSeed() {
  const char* given = std::getenv("PLATON_SEED");
  return given == nullptr ? 1 : std::strtoull(given, nullptr, 10);
}

/// Calls `check` with `count` sources of random numbers, up to the first failure.
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

/// Of magnitude `most` or less, and often something at which arithmetic breaks: 0, 1, the ends, powers of two and their
/// neighbours. most < 2^63.
inline std::int64_t anyInteger(oracle::RandomSource& random, std::int64_t most) {
  const auto within = [most](std::int64_t value) { return value > most ? most : value < -most ? -most : value; };
  const std::int64_t sign = random.oneIn(2) ? 1 : -1;
  switch (random.below(5)) {
    case 0:
      return random.between(-1, 1);
    case 1:
      return sign * (most - random.between(0, most < 2 ? most : 2));
    case 2:
      return within(sign * ((std::int64_t{1} << random.between(0, 61)) + random.between(-1, 1)));
    case 3:
      return within(random.between(-1000, 1000));
    default:
      return sign * random.between(0, most);
  }
}

}  // namespace platon::properties
