#pragma once

#include <cstdint>

#include "platon/exact/precise_point.h"
#include "platon/physics/entity_state.h"

namespace platon {

/// Distances in subunits within which the step treats things as equal or near, and how they depend on each other.
struct Tolerances {
  /// I3: a segment end that protrudes by at most this much does not stop an entity. Two ends at one joint, each off by
  /// up to 2 subunits along both axes, are up to 5.7 subunits apart, and the position is up to one from the ideal
  /// place.
  static constexpr std::int32_t kNudge = 7;
  /// I3: a segment end is at a joint if another segment is this near to it along both axes: no nudge clears an end that
  /// protrudes more.
  static constexpr std::int32_t kJoint = kNudge;
  /// The same if the other segment is on a neighbouring face: instances differ by up to 4 subunits from their exact
  /// placement (I5).
  static constexpr std::int32_t kJointAcross = kJoint + 4;
  /// An entity this near to a segment touches it: the lattice may have no nearer point.
  static constexpr std::int32_t kContactGap = 2;
  /// The lattice position follows the ideal place within this distance. If it cannot, the ideal place falls back to it.
  static constexpr std::int32_t kFollow = 4;
  /// An instance is inserted when the shape with this margin reaches the warp segment: before the shape enters the
  /// part.
  static constexpr std::int32_t kInsert = 4;
  /// An instance is dropped only at this distance from its warp segment.
  static constexpr std::int32_t kDrop = 8;
  static_assert(kDrop > kInsert, "instances would be dropped and inserted alternately");
  /// Obstacles this near to the lattice path, along both axes, are compared with the ideal path.
  static constexpr std::int32_t kNear = 12;
  static_assert(kNear > kRemainderLimit / PrecisePoint::kOne + 1, "the ideal path could leave the compared area");
  /// A move that ends this near to the path of its leg, along both axes, reaches only those obstacles.
  static constexpr std::int32_t kBeside = 6;
  static_assert(kBeside > kFollow);

  /// In 2^-kBits subunits: an ideal place this near to an edge is on it, times the one-norm of the normal.
  static constexpr std::int64_t kOnEdge = 16;
  /// In 2^-kBits subunits: the same after a projection onto it.
  static constexpr std::int64_t kRounding = 2;
  static_assert(kOnEdge > 4 * kRounding);
  /// In 2^-kBits subunits: a shorter move of the ideal place is none.
  static constexpr std::int64_t kNoProgress = 64;
  /// In 2^-kBits subunits a tick: a body that would slide by less than one subunit rests. Velocities are rounded to
  /// subunits, so that one straight towards a slanted floor is off by up to half a subunit.
  static constexpr std::int64_t kRest = PrecisePoint::kOne;
};

}  // namespace platon
