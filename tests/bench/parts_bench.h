#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

/// Cost of a step of one body in a scene with or without a certain part.
struct PartResult {
  std::string scene;
  double instances = 0;  ///< average number of instances
  double crossings = 0;  ///< per step
  Spread nsPerStep;
};

/// Measures what warps, instances, crossings, rotation and rules cost a step that uses them, and one that does not.
std::vector<PartResult> benchParts(const Effort& effort);

}  // namespace platon::bench
