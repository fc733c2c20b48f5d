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
  double maxOverlap = 0;        ///< of the mover and any line after any step: the shortest way out, subunits
  std::int64_t tunnelled = 0;   ///< times that it was outside the closed room, or below the floor, afterwards; it is
                                ///< then put back
  std::int64_t speedDrops = 0;  ///< steps that made less than 99 % of the way along a straight floor
  std::int64_t pops = 0;        ///< steps after which it stood more than 5 mm above where it rests on that floor
  double restDrift = 0;         ///< between the thousandth step and the last, pressed into one place, subunits
  double restGap = 0;  ///< what is left, pressed into one place, between it and the nearest line, subunits; below 0
                       ///< where it overlaps
};

/// Every engine in every hard case; at least 10^5 steps each, less by the effort's share.
std::vector<HardResult> benchHardCases(const Effort& effort);

}  // namespace platon::bench
