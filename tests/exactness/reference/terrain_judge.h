#pragma once

#include <cstdint>
#include <string>

#include "tests/exactness/reference/exact_scene.h"

namespace platon::reference {

/// I8: the lattice position of a body is never farther from the ideal one, in subunits.
inline constexpr double kMaxLatticeError = 2;

/// A scene counts only if the ideal body is in contact within this many last ticks.
inline constexpr std::int64_t kContactTicks = 100;

/// Distance of the simulated body from the ideal one in one scene, in subunits.
struct Verdict {
  std::int64_t ticks = 0;
  std::size_t idealLegs = 0;
  bool inContact = false;       ///< the ideal body is in contact within the last kContactTicks
  double restsAt = -1;          ///< tick at which the ideal body comes to rest, or -1
  double maxLattice = 0;        ///< largest distance of the lattice position, after any tick
  double maxPrecise = 0;        ///< largest distance of position + remainder
  std::int64_t firstAbove = 0;  ///< first tick after which the lattice position is above kMaxLatticeError, or 0

  bool holds() const { return firstAbove == 0; }
};

/// Runs the simulation and the ideal path side by side and never resynchronises them. Throws std::runtime_error if the
/// body starts inside an obstacle.
Verdict judge(const ExactScene& scene, std::int64_t ticks);

}  // namespace platon::reference
