#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"
#include "tests/bench/steps/jam.h"

namespace platon::bench {

struct StepResult {
  std::string scenes;  ///< "random" or "platformer"
  std::string engine;
  std::size_t segments = 0;
  std::size_t bodies = 0;
  Spread nsPerStep;            ///< per body
  double bytesPerSegment = 0;  ///< heap that segments add, without bodies
  double bytesPerBody = 0;     ///< heap that bodies add after a second, including caches of nearby segments
  Jams jams;                   ///< in four seconds after all passes
};

/// Measures bodies with random velocities among random segments, and the bodies of a platformer. Every engine gets the
/// same scenes and commands; Platon is measured with and without its memory of rests.
std::vector<StepResult> benchSteps(const Effort& effort);

}  // namespace platon::bench
