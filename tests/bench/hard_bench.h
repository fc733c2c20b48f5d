#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct HardResult {
  std::string name;
  std::string engine;
  std::int64_t steps = 0;
  double maxOverlap = 0;        ///< largest penetration depth after any step, subunits
  std::int64_t tunnelled = 0;   ///< how often the body left the closed room or fell below the floor; it is then reset
  std::int64_t speedDrops = 0;  ///< steps with less than 99 % of the ideal progress along a straight floor
  std::int64_t pops = 0;        ///< steps that end more than 5 mm above the height of rest on that floor
  double restDrift = 0;         ///< motion at rest, from the thousandth step to the last, subunits
  double restGap = 0;           ///< distance to the nearest segment at rest, subunits; negative if it overlaps
};

/// Measures every engine in every hard case, with 10^5 / effort.divisor steps each.
std::vector<HardResult> benchHardCases(const Effort& effort);

}  // namespace platon::bench
