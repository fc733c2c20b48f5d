#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct ResolutionResult {
  std::string engine;
  std::int64_t subunitsPerUnit = 0;
  Spread nsPerStep;
  double maxTrajectoryError = 0;  ///< over all scenes and ticks, level units
};

/// Measures the scenes of tests/exactness/reference at 2^4 ... 2^16 subunits per unit against their exact trajectories.
/// Requires the root of the tree as working folder.
std::vector<ResolutionResult> benchResolutions(const Effort& effort);

}  // namespace platon::bench
