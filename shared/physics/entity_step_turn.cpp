// The rotation stage of a step.
#include "shared/physics/entity_step.h"

#include <algorithm>
#include <cstdlib>

namespace platon {
namespace {

// A shape is turned in parts of at most 5 degrees: the corners then bulge out of the hull of old and new shape by less
// than 1/1000 of the radius.
constexpr std::int32_t kTurnPart = 500;

bool isIn(const std::vector<Collider::Pierced>& some, const Collider::Pierced& one) {
  return std::find(some.begin(), some.end(), one) != some.end();
}

}  // namespace

// Where a part is not free, smaller ones are tried, down to a centidegree: the hull of a large turn holds
// more than the shape sweeps over. Past a narrow place they grow again.
void EntityStep::turn(std::int32_t centidegrees) {
  std::int32_t most = kTurnPart;
  while (centidegrees != 0) {
    const std::int32_t part = std::clamp(centidegrees, -most, most);
    if (tryTurn(part)) {
      centidegrees -= part;
      most = std::min(2 * most, kTurnPart);
    } else if (most = std::abs(part) / 2; most == 0) {
      if (const auto blocker = turnBlocker(part, 0)) rules_->touchContact(*entity_, *blocker);
      return;
    }
  }
}

bool EntityStep::tryTurn(std::int32_t centidegrees) {
  const std::size_t known = instances_.all().size();
  if (turnBlocker(centidegrees, 0) || !admitTurn(centidegrees) || turnBlocker(centidegrees, known)) return false;
  turnBy(centidegrees);
  return true;
}

// Then pierceable lines are left and met, in this order.
void EntityStep::turnBy(std::int32_t centidegrees) {
  piercedBefore_.clear();
  piercedAfter_.clear();
  for (const Placement& placement : instances_.all()) {
    if (!placement.fresh) collider_.appendPierced(placement, piercedBefore_);
  }
  instances_.turn(centidegrees);
  state_->angle = instances_.home().angle;
  observe();
  for (Placement& placement : instances_.all()) {
    collider_.appendPierced(placement, piercedAfter_);
    placement.fresh = false;
  }
  for (const Collider::Pierced& one : piercedBefore_) {
    if (!isIn(piercedAfter_, one)) rules_->endContact(*entity_, refOf(one));
  }
  for (const Collider::Pierced& one : piercedAfter_) {
    if (!isIn(piercedBefore_, one)) rules_->beginContact(*entity_, refOf(one));
  }
}

SegmentRef EntityStep::refOf(const Collider::Pierced& pierced) const {
  const auto& all = instances_.all();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Placement& placement) { return placement.id == pierced.instance; });
  return segmentRef(*found->part, pierced.line);
}

// The first line, home before other instances, that the turning shape would meet; the first instances may be left out.
std::optional<SegmentRef> EntityStep::turnBlocker(std::int32_t centidegrees, std::size_t from) {
  for (std::size_t i = from; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    const Convex* hull = instances_.hullOfTurn(i, centidegrees);
    if (hull == nullptr) continue;
    if (const auto line = collider_.overlapped(placement, *hull)) return segmentRef(*placement.part, *line);
  }
  return std::nullopt;
}

// Adds the instances that the turning shape reaches. False when one cannot be placed or the shape degenerates.
bool EntityStep::admitTurn(std::int32_t centidegrees) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Convex* hull = instances_.hullOfTurn(i, centidegrees);
    if (hull == nullptr) return false;
    const MapGeometry& part = *instances_.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!collider_.meetsWarp(instances_, {i, warp}, *hull, kInsertMargin)) continue;
      if (instances_.fullBehind(i) || !instances_.insert(i, warp, collider_)) return false;
    }
  }
  return true;
}

}  // namespace platon
