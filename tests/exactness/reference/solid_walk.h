#pragma once

#include <cstdint>
#include <cstdio>

#include "platon/game/solid.h"

namespace platon::reference {

/// How a random walk over the edges of a solid is driven.
enum class Drive {
  kPush,     ///< a constant velocity, which turns with the frames; another one after every few dozen ticks
  kGravity,  ///< every face has its own direction of falling; the body also walks to one side or the other
};

/// Why the judgement of a walk ended.
enum class WalkEnd {
  kTicks,   ///< all ticks are judged
  kJoint,   ///< the ideal body was stopped at a joint (SolidPath::wasStoppedAtJoint)
  kTie,     ///< a second ideal body, 1/64 subunit aside, came to be more than 2 subunits away
  kNarrow,  ///< the ideal body went on into a wedge where no lattice point within 2 subunits is free
};

/// Distances of a simulated body from the ideal one, in subunits.
struct WalkVerdict {
  WalkEnd end = WalkEnd::kTicks;
  std::int64_t judgedTicks = 0;
  std::int64_t contactTicks = 0;  ///< ticks in which the ideal body has a contact
  std::int64_t crossings = 0;     ///< changes of the home face
  std::int64_t narrowTicks = 0;  ///< ticks after which no lattice point within 2 subunits is free (SolidPath::isNarrow)
  double maxLattice = 0;         ///< largest distance of the lattice position while the body is on one face, not narrow
  double maxOverEdges = 0;       ///< the same while it is on several faces, whose lattices differ
  double maxNarrow = 0;          ///< the same after narrow ticks
  double maxPrecise = 0;         ///< largest distance of position + remainder

  bool holds() const { return maxLattice <= 2 && maxOverEdges <= 3; }
};

/// A random walk on a solid with random walls, of which many continue over an edge or end beside it, with ends off by
/// up to 2 subunits along both axes. Both bodies get the same velocities and are never resynchronised; places are
/// compared in the frame of the simulated body's home face.
WalkVerdict judgeWalk(SolidKind kind, Drive drive, std::uint64_t seed, std::int64_t ticks);

/// Judges `count` walks on every solid with every drive and prints a row for each. Returns true if all hold.
bool judgeWalks(std::uint64_t firstSeed, std::int64_t count, std::int64_t ticks, std::FILE* out);

}  // namespace platon::reference
