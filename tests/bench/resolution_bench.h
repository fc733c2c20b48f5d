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

/// The scenes of tests/exactness/reference at 2^4 ... 2^16 subunits a unit, against their ideal trajectory in
/// rationals. Run from the root of the tree.
std::vector<ResolutionResult> benchResolutions(const Effort& effort);

}  // namespace platon::bench
