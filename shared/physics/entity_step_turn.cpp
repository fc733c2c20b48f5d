// The rotation stage of a step.
#include "shared/physics/entity_step.h"

#include <algorithm>
#include <cstdlib>

namespace platon {
namespace {

// A shape is turned in parts of at most 5 degrees: the corners then bulge out of the hull of old and new shape by less
// than 1/1000 of the radius.
constexpr std::int32_t kTurnPart = 500;
constexpr std::int32_t kInsertMargin = 4;

// The hull of a shape before and after a turn; none when it degenerates.
std::optional<Convex> hullOf(const Convex& before, const Convex* after) {
  if (after == nullptr) return std::nullopt;
  std::vector<Point> points = before.vertices();
  points.insert(points.end(), after->vertices().begin(), after->vertices().end());
  return Convex(convexHull(std::move(points)));
}

std::vector<Collider::Pierced> without(std::vector<Collider::Pierced> all, const std::vector<Collider::Pierced>& some) {
  std::erase_if(all,
                [&](const Collider::Pierced& one) { return std::find(some.begin(), some.end(), one) != some.end(); });
  return all;
}

}  // namespace

// Where a part is not free, smaller ones are tried, down to a hundredth of a degree: the hull of a large turn holds
// more than the shape sweeps over.
void EntityStep::turn(std::int32_t hundredths) {
  std::int32_t most = kTurnPart;
  while (hundredths != 0) {
    const std::int32_t part = std::clamp(hundredths, -most, most);
    if (tryTurn(part)) {
      hundredths -= part;
    } else if (most = std::abs(part) / 2; most == 0) {
      if (const auto blocker = turnBlocker(part)) rules_->touchContact(*entity_, *blocker);
      return;
    }
  }
}

bool EntityStep::tryTurn(std::int32_t hundredths) {
  if (turnBlocker(hundredths) || !admitTurn(hundredths) || turnBlocker(hundredths)) return false;
  turnBy(hundredths);
  return true;
}

// Then pierceable lines are left and met, in this order.
void EntityStep::turnBy(std::int32_t hundredths) {
  std::vector<Collider::Pierced> before;
  std::vector<Collider::Pierced> after;
  for (const Placement& placement : instances_.all()) {
    if (!placement.fresh) collider_.appendPierced(placement, before);
  }
  instances_.turn(hundredths);
  state_->angle = instances_.home().angle;
  observe();
  for (Placement& placement : instances_.all()) {
    collider_.appendPierced(placement, after);
    placement.fresh = false;
  }
  for (const Collider::Pierced& left : without(before, after)) rules_->endContact(*entity_, refOf(left));
  for (const Collider::Pierced& met : without(after, before)) rules_->beginContact(*entity_, refOf(met));
}

LineRef EntityStep::refOf(const Collider::Pierced& pierced) const {
  const auto& all = instances_.all();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Placement& placement) { return placement.id == pierced.instance; });
  return lineRef(*found->part, pierced.line);
}

// The first line, home before other instances, that the turning shape would meet.
std::optional<LineRef> EntityStep::turnBlocker(std::int32_t hundredths) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const Placement& placement = instances_.all()[i];
    const auto hull = hullOf(*placement.shape, instances_.shapeTurned(i, hundredths));
    if (!hull) continue;
    if (const auto line = collider_.overlapped(placement, *hull)) return lineRef(*placement.part, *line);
  }
  return std::nullopt;
}

// Adds the instances that the turning shape reaches. False when one cannot be placed or the shape degenerates.
bool EntityStep::admitTurn(std::int32_t hundredths) {
  for (std::size_t i = 0; i < instances_.all().size(); ++i) {
    const auto hull = hullOf(*instances_.all()[i].shape, instances_.shapeTurned(i, hundredths));
    if (!hull) return false;
    const MapGeometry& part = *instances_.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!collider_.meetsWarp(instances_, {i, warp}, *hull, kInsertMargin)) continue;
      if (instances_.fullBehind(i) || !instances_.insert(i, warp, collider_)) return false;
    }
  }
  return true;
}

}  // namespace platon
