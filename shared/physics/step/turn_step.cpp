#include "shared/physics/step/turn_step.h"

#include <algorithm>
#include <cstdlib>

#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Limit of one portion of a rotation, in centidegrees (5°). The arcs of the vertices then extend beyond the hull of the
// old and the new shape by less than 1/1000 of the radius.
constexpr std::int32_t kMaxPortion = 500;

}  // namespace

// When a portion is blocked, smaller ones are tried, down to a centidegree, because the hull of a large portion is
// larger than the area that the shape sweeps. After a free portion the size doubles again.
void TurnStep::turn(std::int32_t centidegrees) {
  std::int32_t limit = kMaxPortion;
  while (centidegrees != 0) {
    const std::int32_t portion = std::clamp(centidegrees, -limit, limit);
    if (tryPortion(portion)) {
      centidegrees -= portion;
      limit = std::min(2 * limit, kMaxPortion);
    } else if (limit = std::abs(portion) / 2; limit == 0) {
      if (const auto segment = blocker(portion, 0)) contacts_.addTouch(*segment);
      return;
    }
  }
}

bool TurnStep::tryPortion(std::int32_t centidegrees) {
  const std::size_t known = mover_.instances().all().size();
  if (blocker(centidegrees, 0) || !insertInstances(centidegrees) || blocker(centidegrees, known)) return false;
  mover_.rotateShapes(centidegrees);
  return true;
}

// The first segment that blocks the rotation, in order of the instances starting at `from`.
std::optional<SegmentRef> TurnStep::blocker(std::int32_t centidegrees, std::size_t from) {
  Instances& instances = mover_.instances();
  Collider& collider = mover_.collider();
  for (std::size_t i = from; i < instances.all().size(); ++i) {
    const Placement& placement = instances.all()[i];
    const auto bounds = instances.rotationBounds(i, centidegrees);
    if (!bounds || !collider.mayOverlap(placement, *bounds)) continue;
    const Convex& hull = *instances.rotationHull(i, centidegrees);
    if (const auto segment = collider.overlapped(placement, hull)) return collider.refOf(placement, *segment);
  }
  return std::nullopt;
}

// Adds the instances that the rotating shape reaches. Returns false when one cannot be placed or the rotated shape is
// degenerate.
bool TurnStep::insertInstances(std::int32_t centidegrees) {
  Instances& instances = mover_.instances();
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    const auto bounds = instances.rotationBounds(i, centidegrees);
    if (!bounds) return false;
    const Box reach = bounds->grown(Tolerances::kInsert);
    const MapGeometry& part = *instances.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!reach.overlaps(boundsOf(part.warps[warp].from))) continue;
      const Convex& hull = *instances.rotationHull(i, centidegrees);
      if (!mover_.collider().reachesWarp(instances, {i, warp}, hull, Tolerances::kInsert)) continue;
      if (instances.isAtInstanceLimit(i) || !mover_.insertBehind(i, warp)) return false;
    }
  }
  return true;
}

}  // namespace platon
