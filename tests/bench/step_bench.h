#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct StepResult {
  std::string engine;
  std::size_t segments = 0;
  std::size_t movers = 0;
  Spread nsPerStep;            ///< of one mover
  double bytesPerSegment = 0;  ///< what the lines add to the heap that the engine takes, without movers
  double bytesPerMover = 0;    ///< what the movers add to that after a second, with what is kept about lines near them
};

/// Movers flung about among random segments, every engine with the same ones.
std::vector<StepResult> benchSteps(const Effort& effort);

}  // namespace platon::bench
