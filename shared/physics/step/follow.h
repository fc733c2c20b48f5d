#pragma once

#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/step/mover.h"

namespace platon {

/// Where the position shall go after a leg of the ideal path.
struct FollowAim {
  PrecisePoint end;   ///< the ideal place, which it shall be near to
  const LegHit* hit;  ///< what ended the leg, on whose outer side it must be; null if nothing did
  PrecisePoint tick;  ///< displacement of the tick: of places equally near and equally far out, one ahead is taken
};

/// Moves the position near to the ideal place, by at most two straight moves, which the exact sweep proves free (I1).
/// Returns false if there is no such way to a place within Tolerances::kFollow of the rounded ideal place: it has then
/// moved nothing, or made the first of two moves, if after it Rules::pierce blocks the second. Requires that the
/// instances have not moved since prepareLeg.
bool follow(Mover& mover, const FollowAim& aim);
/// Moves the position towards `end` as far as the lattice allows. Returns whether it moved.
bool fallBack(Mover& mover, PrecisePoint end);

}  // namespace platon
