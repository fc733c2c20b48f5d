#pragma once

#include <cstddef>

#include "tests/bench/engines/engine.h"
#include "tests/bench/steps/step_runner.h"

namespace platon::bench {

/// Half seconds in which a body was jammed. It is jammed if it moves by less than kJammed of the wanted distance, where
/// float64 moves by more than kFree of it, from the same place with the same velocity. There, the shape is smaller by
/// kSmaller, which is more than the slop of every engine, so that a body in contact does not overlap; segments that it
/// overlaps all the same do not stop it. If the body itself overlaps nothing there, float64 must move on with the full
/// shape, too. In a scene with gravity, only walking counts, and float64 falls from rest.
struct Jams {
  std::size_t halfSeconds = 0;  ///< of one body each; bodies that shall not move do not count
  std::size_t jammed = 0;

  double share() const { return halfSeconds == 0 ? 0 : static_cast<double>(jammed) / static_cast<double>(halfSeconds); }
};

inline constexpr double kJammed = 0.1;
inline constexpr double kFree = 0.5;
inline constexpr double kSmaller = 0.02;

/// Runs at least eight half seconds, and a single body longer, and counts the jams of the first 64 bodies.
Jams countJams(StepRunner& runner, const Scene& scene);

}  // namespace platon::bench
