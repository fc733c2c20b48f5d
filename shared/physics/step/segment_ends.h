#pragma once

#include <optional>

#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/step/mover.h"
#include "shared/physics/step/slide.h"

namespace platon {

/// I3: segment ends that protrude slightly at a joint do not stop an entity.

/// A way past a segment end.
struct Nudge {
  Point to;       ///< the position beside the end, to which the straight way is free
  Point onwards;  ///< the displacement from there that leads past the end
};

/// Whether an end, hit at the ideal place `place` with `remaining` left of the displacement, stops the ideal place or
/// leaves it less than 1/32 of its speed. Otherwise it slides along the end, as it does if the end is past in 1/32 of
/// the remaining time.
bool isBlockedByEnd(const Slide& slide, const LegHit& hit, PrecisePoint place, PrecisePoint remaining);

/// The way past the segment end that `hit` touches, from an edge with this normal in the home frame, on which the ideal
/// place is at `from` and slides with `remaining` left of the displacement. Where the normal is that of the end itself,
/// it goes straight on. Nothing if `hit` touches no end, or if the end does not protrude slightly at a joint.
std::optional<Nudge> findNudge(Mover& mover, const Slide& slide, const LegHit& hit, Point normal, PrecisePoint from,
                               PrecisePoint remaining);

}  // namespace platon
