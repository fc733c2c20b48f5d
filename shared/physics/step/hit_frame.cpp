#include "shared/physics/step/hit_frame.h"

#include "shared/physics/turned_normal.h"

namespace platon {

Point normalOf(const Instances& instances, const LegHit& hit) {
  if (hit.hit.side != Hit::Side::kInside) return hit.hit.normal;
  const Segment& segment = segmentOf(instances, hit);
  return perpendicular(segment.b - segment.a);
}

Point homeNormalOf(const Instances& instances, const LegHit& hit) {
  const Point normal = normalOf(instances, hit);
  return hit.placement == 0 ? normal : turnedNormal(normal, placementOf(instances, hit).toHome);
}

}  // namespace platon
