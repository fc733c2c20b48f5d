#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct SweepResult {
  std::string set;
  std::string engine;
  Spread nsPerQuery;
  std::size_t queries = 0;
  std::size_t hits = 0;       ///< queries whose correct answer is a hit
  std::size_t missed = 0;     ///< hits that the engine does not report
  std::size_t falseHits = 0;  ///< reported hits where there is none
  double maxTimeError = 0;    ///< of the reported hits, as a fraction of the displacement
  double maxOverlap = 0;      ///< penetration depth at the reported time, or on a path reported as free; subunits
};

/// Measures every set with every engine that can sweep a polygon. Chipmunk cannot.
std::vector<SweepResult> benchSweeps(const Effort& effort);

}  // namespace platon::bench
