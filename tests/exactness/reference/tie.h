#pragma once

#include <cstdint>

#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/ideal_path.h"

namespace platon::reference {

/// A scene has a tie if a tiny change leads the ideal body elsewhere. Only ideal paths are compared, never the
/// simulated body. These changes are tried:
///
/// 1. The body is larger, or smaller, by at least kTieSubunits on each side, so that every gap between two segments is
///    narrower or wider by twice as much. It is a tie when the two bodies are more than kSeparation apart. (Without a
///    tie they stay closer: each is a little late or early at every corner.)
/// 2. Every free flight is moved to each side by kTieSubunits, where the body is free. It is a tie when the body moved
///    does not come back to the path: to a slide along the same edge or to the same rest. So the body meets the vertex
///    of an obstacle whose sides lead it in different directions, or passes an obstacle that would stop it.
/// 3. A body at rest is moved by kTieSubunits in each of 16 directions in which it is free. It is a tie when it then
///    goes on and does not come back to within kSeparation of the rest. So a body rests only where it is held firmly.
///
/// Narrow rests. Where no lattice point within kReach of the rest is free, because the wedge is too narrow, no body on
/// the lattice can be as near.
///
/// Joints. The ideal path takes segments as they are. A body slides over an end that protrudes if the velocity leads it
/// over that end; a body that is stopped there rests for ever, which I3 forbids to the simulation. So a rest at an end
/// that is at most kJoint from another segment along both axes is named kJoint if a body lifted by kLift goes on. So is
/// a slide on such an end at less than kSlow of the speed, which is as good as a stop.
struct Tie {
  enum class Kind { kNone, kDivided, kNarrow, kJoint };

  Kind kind = Kind::kNone;
  double tick = 0;  ///< tick at which the tie shows
};

/// More than a hundred times the error of position and remainder after 36 000 ticks.
inline constexpr double kTieSubunits = 1.0 / 64;
inline constexpr std::int64_t kReach = 2;
/// A nudge of the simulation leads up to 7 subunits from a place that is up to 1 from the ideal one.
inline constexpr double kLift = 8;
/// The simulation nudges a body past an end only if another segment is so near to it.
inline constexpr std::int64_t kJoint = 7;
/// Smallest share of its speed that the ideal body keeps on an end at a joint.
inline constexpr double kSlow = 1.0 / 32;
/// Up to this many ticks; in proportion after that.
inline constexpr double kSeparation = 256;
inline constexpr double kSeparationTicks = 1200;

/// The earliest tie of a scene, which must start at least 2 subunits from every segment. `ideal` is its path for
/// `ticks` ticks.
Tie findTie(const ExactScene& scene, const IdealPath& ideal, std::int64_t ticks);

}  // namespace platon::reference
