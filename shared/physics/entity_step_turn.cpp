// The rotation stage of a step.
#include "shared/physics/entity_step.h"

#include <algorithm>

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

}  // namespace

void EntityStep::turn(std::int32_t hundredths) {
  while (hundredths != 0) {
    const std::int32_t part = std::clamp(hundredths, -kTurnPart, kTurnPart);
    if (!tryTurn(part)) {
      turnAsFarAsFree(part);
      return;
    }
    hundredths -= part;
  }
}

bool EntityStep::tryTurn(std::int32_t hundredths) {
  if (!admitTurn(hundredths) || turnBlocker(hundredths)) return false;
  turnBy(hundredths);
  return true;
}

// Bisects to the last angle that is free; a whole hundredth of a degree is the smallest turn.
void EntityStep::turnAsFarAsFree(std::int32_t hundredths) {
  const std::int32_t unit = hundredths > 0 ? 1 : -1;
  std::int32_t free = 0;
  std::int32_t blocked = hundredths * unit;
  while (blocked - free > 1) {
    const std::int32_t middle = (free + blocked) / 2;
    const bool isFree = admitTurn(middle * unit) && !turnBlocker(middle * unit);
    (isFree ? free : blocked) = middle;
  }
  const auto blocker = turnBlocker(blocked * unit);
  if (free != 0) turnBy(free * unit);
  if (blocker) rules_->touchContact(*entity_, *blocker);
}

void EntityStep::turnBy(std::int32_t hundredths) {
  instances_.turn(hundredths);
  state_->angle = instances_.home().angle;
  observe();
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
