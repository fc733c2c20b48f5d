#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct StepResult {
  std::string engine;
  std::size_t segments = 0;
  std::size_t movers = 0;
  Spread nsPerStep;            ///< per mover
  double bytesPerSegment = 0;  ///< heap that segments add, without movers
  double bytesPerMover = 0;    ///< heap that movers add after a second, including caches of nearby segments
};

/// Measures movers with random velocities among random segments. Every engine gets the same scenes.
std::vector<StepResult> benchSteps(const Effort& effort);

}  // namespace platon::bench
