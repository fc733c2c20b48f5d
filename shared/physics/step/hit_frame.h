#pragma once

#include "platon/exact/precise_point.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"

namespace platon {

/// A hit belongs to the frame of the part in which it happens, the ideal path to the frame of the home part. These
/// functions lead from one to the other.

/// The instance that hits.
inline const Placement& placementOf(const Instances& instances, const LegHit& hit) {
  return instances.all()[hit.placement];
}
/// The segment that is hit, in the frame of its part.
inline const Segment& segmentOf(const Instances& instances, const LegHit& hit) {
  return placementOf(instances, hit).part->segments[hit.segment];
}
/// A displacement in the frame of the part whose segment was hit.
inline PrecisePoint fromHome(const Instances& instances, const LegHit& hit, PrecisePoint displacement) {
  return hit.placement == 0 ? displacement : rotated(displacement, placementOf(instances, hit).fromHome);
}
/// And back.
inline PrecisePoint toHome(const Instances& instances, const LegHit& hit, PrecisePoint displacement) {
  return hit.placement == 0 ? displacement : rotated(displacement, placementOf(instances, hit).toHome);
}
/// The normal of a hit. For a warp segment that the shape with margin overlaps already: the direction into its part.
Point normalOf(const Instances& instances, const LegHit& hit);
/// The same in the frame of the home part.
Point homeNormalOf(const Instances& instances, const LegHit& hit);

}  // namespace platon
