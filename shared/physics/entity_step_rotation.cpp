// The rotation stage of a step.
#include "shared/physics/entity_step.h"

#include <algorithm>
#include <cstdlib>

namespace platon {
namespace {

// Limit of one part of a rotation, in centidegrees (5°). The arcs of the vertices then extend beyond the hull of the
// old and the new shape by less than 1/1000 of the radius.
constexpr std::int32_t kMaxRotationStep = 500;

bool contains(const std::vector<Collider::Pierced>& all, const Collider::Pierced& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

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
      if (const auto blocker = rotationBlocker(part, 0)) rules_->touchContact(*entity_, *blocker);
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

// Rotates all instances and calls the rules: first endContact, then beginContact.
void EntityStep::rotateBy(std::int32_t centidegrees) {
  piercedBefore_.clear();
  piercedAfter_.clear();
  for (const Placement& placement : instances_.all()) {
    if (!placement.fresh) collider_.appendPierced(placement, piercedBefore_);
  }
  instances_.rotateShapes(centidegrees);
  state_->angle = instances_.home().angle;
  observe();
  for (Placement& placement : instances_.all()) {
    collider_.appendPierced(placement, piercedAfter_);
    placement.fresh = false;
  }
  for (const Collider::Pierced& one : piercedBefore_) {
    if (!contains(piercedAfter_, one)) rules_->endContact(*entity_, refOf(one));
  }
  for (const Collider::Pierced& one : piercedAfter_) {
    if (!contains(piercedBefore_, one)) rules_->beginContact(*entity_, refOf(one));
  }
}

SegmentRef EntityStep::refOf(const Collider::Pierced& pierced) const {
  const auto& all = instances_.all();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Placement& placement) { return placement.id == pierced.instance; });
  return segmentRef(*found->part, pierced.segment);
}

// The first segment that blocks the rotation, in order of the instances starting at `from`.
std::optional<SegmentRef> EntityStep::rotationBlocker(std::int32_t centidegrees, std::size_t from) {
  for (std::size_t i = from; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    const Convex* hull = instances_.rotationHull(i, centidegrees);
    if (hull == nullptr) continue;
    if (const auto segment = collider_.overlapped(placement, *hull)) return segmentRef(*placement.part, *segment);
  }
  return std::nullopt;
}

// Adds the instances that the rotating shape reaches. Returns false when one cannot be placed or the rotated shape is
// degenerate.
bool EntityStep::insertInstancesForRotation(std::int32_t centidegrees) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Convex* hull = instances_.rotationHull(i, centidegrees);
    if (hull == nullptr) return false;
    const MapGeometry& part = *instances_.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!collider_.reachesWarp(instances_, {i, warp}, *hull, Tolerances::kInsert)) continue;
      if (instances_.isAtInstanceLimit(i) || !instances_.insert(i, warp, collider_)) return false;
    }
  }
  return true;
}

}  // namespace platon
