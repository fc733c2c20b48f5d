#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {

/// The bodies of all commands keep their velocities for this many steps.
inline constexpr int kStepsOfOneVelocity = 30;

/// A kind of scene for whole steps, and the velocities that its bodies get.
struct StepScenes {
  std::string name;
  /// A scene with this many segments and bodies.
  Scene (*make)(std::size_t segments, std::size_t bodies);
  /// The next velocity of a body, for kStepsOfOneVelocity steps. In a scene with gravity, y is the speed of a jump in
  /// the first of them. A body whose velocity is 0 is at rest; it is never set.
  Place (*velocityOf)(std::size_t body, sim::SeededRandom& random);
};

/// Octagons with random velocities among random segments, evenly distributed over a square that grows with their
/// number.
const StepScenes& randomScenes();

/// Storeys of tiles of 1 m, some of them raised by 1 m, with gravity. Octagons walk along them at 6 m/s and jump; a
/// third of them stand.
const StepScenes& platformerScenes();

}  // namespace platon::bench
