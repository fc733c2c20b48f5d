// The rotation stage of a step.
#include "shared/physics/step/entity_step.h"

#include <algorithm>
#include <cstdlib>

namespace platon {
namespace {

// Limit of one part of a rotation, in centidegrees (5°). The arcs of the vertices then extend beyond the hull of the
// old and the new shape by less than 1/1000 of the radius.
constexpr std::int32_t kMaxRotationStep = 500;

}  // namespace

// Rotates in parts. When a part is blocked, smaller ones are tried, down to a centidegree, because the hull of a large
// part is larger than the area that the shape sweeps. After a free part the size doubles again.
void EntityStep::rotateShape(std::int32_t centidegrees) {
  std::int32_t limit = kMaxRotationStep;
  while (centidegrees != 0) {
    const std::int32_t part = std::clamp(centidegrees, -limit, limit);
    if (tryRotation(part)) {
      centidegrees -= part;
      limit = std::min(2 * limit, kMaxRotationStep);
    } else if (limit = std::abs(part) / 2; limit == 0) {
      if (const auto blocker = rotationBlocker(part, 0)) addEvent(StepEvents::Kind::kTouch, *blocker);
      return;
    }
  }
}

bool EntityStep::tryRotation(std::int32_t centidegrees) {
  const std::size_t known = instances_.all().size();
  if (rotationBlocker(centidegrees, 0) || !insertInstancesForRotation(centidegrees) ||
      rotationBlocker(centidegrees, known))
    return false;
  rotateBy(centidegrees);
  return true;
}

// The contacts that end come before those that begin.
void EntityStep::rotateBy(std::int32_t centidegrees) {
  instances_.rotateShapes(centidegrees);
  collider_.turnShape(Angle(centidegrees));
  state_.angle = instances_.home().angle;
  observe();
  if (collider_.ignoresWarps()) return;
  for (const Placement& placement : instances_.all()) collider_.recordOverlapped(placement);
  updateContacts();
}

// The first segment that blocks the rotation, in order of the instances starting at `from`.
std::optional<SegmentRef> EntityStep::rotationBlocker(std::int32_t centidegrees, std::size_t from) {
  for (std::size_t i = from; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    const auto bounds = instances_.rotationBounds(i, centidegrees);
    if (!bounds || !collider_.mayOverlap(placement, *bounds)) continue;
    const Convex& hull = *instances_.rotationHull(i, centidegrees);
    if (const auto segment = collider_.overlapped(placement, hull)) return collider_.refOf(placement, *segment);
  }
  return std::nullopt;
}

// Adds the instances that the rotating shape reaches. Returns false when one cannot be placed or the rotated shape is
// degenerate.
bool EntityStep::insertInstancesForRotation(std::int32_t centidegrees) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const auto bounds = instances_.rotationBounds(i, centidegrees);
    if (!bounds) return false;
    const Box reach = bounds->grown(Tolerances::kInsert);
    const MapGeometry& part = *instances_.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!reach.overlaps(boundsOf(part.warps[warp].from))) continue;
      const Convex& hull = *instances_.rotationHull(i, centidegrees);
      if (!collider_.reachesWarp(instances_, {i, warp}, hull, Tolerances::kInsert)) continue;
      if (instances_.isAtInstanceLimit(i) || !instances_.insert(i, warp, collider_)) return false;
    }
  }
  return true;
}

}  // namespace platon
