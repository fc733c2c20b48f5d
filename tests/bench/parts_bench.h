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
  /// Calls of operator new per step; 0 if the caches are warm.
  double allocations = 0;
  Spread nsPerStep;
};

/// Measures what warps, instances, crossings, rotation and rules cost a step that uses them, and one that does not.
/// In a scene with a name that ends with "new angles", no angle of a measured step occurred before.
std::vector<PartResult> benchParts(const Effort& effort);

}  // namespace platon::bench
