#pragma once

#include <cstdint>
#include <optional>

#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/judged_body.h"
#include "tests/exactness/reference/tie.h"

namespace platon::reference {

/// I8: the lattice position of a body is never farther from the ideal one, in subunits.
inline constexpr double kMaxLatticeError = 2;

/// I8: position and remainder are never farther from the ideal position: 10^-6 units.
inline constexpr double kMaxPreciseError = 1024e-6;

/// A scene counts only if the ideal body is in contact within this many last ticks.
inline constexpr std::int64_t kContactTicks = 100;

/// Distance of the simulated body from the ideal one in one scene, in subunits.
struct Verdict {
  std::int64_t ticks = 0;
  std::size_t idealLegs = 0;
  bool inContact = false;         ///< the ideal body is in contact within the last kContactTicks
  std::optional<double> restsAt;  ///< tick at which the ideal body comes to rest
  Tie tie;
  std::int64_t judgedTicks = 0;  ///< all without a tie; those before it; none if the path is divided
  double maxLattice = 0;         ///< largest distance of the lattice position, after any tick that is judged
  double maxPrecise = 0;         ///< largest distance of position + remainder
  std::int64_t firstAbove = 0;   ///< first tick after which the lattice position is above kMaxLatticeError, or 0

  bool counts() const { return inContact && tie.kind != Tie::Kind::kJoint; }
  bool holds() const { return firstAbove == 0; }
};

/// Runs the body and the ideal path side by side and never resynchronises them. The body starts at the start of the
/// scene. Throws std::runtime_error if it is inside an obstacle there.
Verdict judge(const ExactScene& scene, std::int64_t ticks, JudgedBody& body);

/// Judges the simulation.
Verdict judge(const ExactScene& scene, std::int64_t ticks);

}  // namespace platon::reference
