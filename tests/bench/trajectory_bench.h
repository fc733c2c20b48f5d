#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

/// Distance of the body of one engine from the ideal one, in one scene.
struct TrajectoryResult {
  std::string scene;
  std::string engine;
  std::int64_t ticks = 0;
  double maxError = 0;  ///< largest distance after any tick up to this one, level units
};

struct TrajectoryResults {
  std::vector<TrajectoryResult> errors;
  std::int64_t scenes = 0;       ///< of tests/exactness/reference/scenes
  std::int64_t terrains = 0;     ///< random terrains that are measured
  std::int64_t dividedTies = 0;  ///< scenes and terrains that are left out, because the ideal path has a tie
  std::int64_t jointTies = 0;    ///< the same, because the tie is at a joint
  std::int64_t leftContact = 0;  ///< terrains that are left out: no contact within the last 100 ticks
};

/// Runs every engine on the scenes of tests/exactness/reference and on random terrains at 1 024 subunits a unit, for up
/// to 36 000 ticks, with the same velocity in every tick, and never resynchronises it with the ideal path. A scene is
/// measured up to the last of these times at which the ideal body has been in contact within 100 ticks. Only the ideal
/// path decides what is left out. Box2D has no part in scenes whose shape has too many vertices. Requires the root of
/// the tree as working folder.
TrajectoryResults benchTrajectories(const Effort& effort);

}  // namespace platon::bench
