#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

/// One mover's step in a scene that has, or has not, what is measured.
struct PartResult {
  std::string scene;
  double instances = 0;  ///< on average
  double crossings = 0;  ///< a step
  Spread nsPerStep;
};

/// What each part of the world costs where it is not needed, and what it costs where it is: warps, instances,
/// crossings, rotation, rules.
std::vector<PartResult> benchParts(const Effort& effort);

}  // namespace platon::bench
