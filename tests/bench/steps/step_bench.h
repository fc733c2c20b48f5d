#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct StepResult {
  std::string engine;
  std::size_t segments = 0;
  std::size_t bodies = 0;
  Spread nsPerStep;            ///< per body
  double bytesPerSegment = 0;  ///< heap that segments add, without bodies
  double bytesPerBody = 0;     ///< heap that bodies add after a second, including caches of nearby segments
};

/// Measures bodies with random velocities among random segments. Every engine gets the same scenes.
std::vector<StepResult> benchSteps(const Effort& effort);

}  // namespace platon::bench
