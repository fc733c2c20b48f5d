#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct SweepResult {
  std::string set;
  std::string engine;
  Spread nsPerQuery;
  std::size_t questions = 0;
  std::size_t meetings = 0;   ///< questions of which the true answer is a meeting
  std::size_t missed = 0;     ///< meetings that the engine does not see
  std::size_t falseHits = 0;  ///< meetings that there are none of
  double maxTimeError = 0;    ///< part of the displacement; of the meetings that it sees
  double maxOverlap = 0;      ///< how deep the shape is in the line at the time the engine tells, or on a way that it
                              ///< calls free; subunits
};

/// Every set by every engine that can sweep a polygon: Chipmunk cannot.
std::vector<SweepResult> benchSweeps(const Effort& effort);

}  // namespace platon::bench
