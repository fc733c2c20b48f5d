#include "shared/physics/step/mover.h"

#include <algorithm>

#include "platon/exact/integer.h"
#include "shared/physics/tolerances.h"

namespace platon {

void Mover::start(PrecisePoint displacement) {
  reach_ = maxNorm(displacement);
  staysInRange_ = staysInRange();
}

// Whether no instance can reach the coordinate limit in this step, in any frame. A rotation at most doubles the maxNorm
// of a displacement, and all nudges and roundings of a step are less than 2^12 subunits.
bool Mover::staysInRange() const {
  constexpr std::int32_t kNear = kCoordinateLimit / 4 - (1 << 12);
  return reach_ < kNear * PrecisePoint::kOne &&
         std::all_of(instances_.all().begin(), instances_.all().end(),
                     [](const Placement& placement) { return maxNorm(placement.position) < kNear; });
}

bool Mover::isEachInRange(Point home) const {
  return std::all_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

void Mover::moveTo(Point position) {
  const Point before = this->position();
  if (position == before) return;
  ++moves_;
  instances_.moveHomeTo(position);
  state_.position = position;
  observe();
  contacts_.updateMoved(before);
}

bool Mover::insertBehind(std::size_t placement, std::uint16_t warp) {
  if (!instances_.insert(placement, warp, collider_)) return false;
  staysInRange_ = staysInRange_ && staysInRange();
  return true;
}

std::optional<Angle> Mover::rehome(PrecisePoint& place) {
  if (!instances_.needsRehome()) return std::nullopt;
  if (instances_.correctDrift(collider_)) {
    observe();
    contacts_.update();
  }
  PrecisePoint remainder = place - precise(position());
  const auto turn = instances_.rehome(remainder);
  if (!turn) return std::nullopt;
  place = precise(position()) + remainder;
  instances_.storeHome(state_);
  state_.heading = state_.heading + *turn;
  observe();
  return turn;
}

void Mover::dropUnreached() {
  if (!instances_.dropUnreached(Tolerances::kDrop, collider_)) return;
  observe();
  contacts_.update();
}

void Mover::rotateShapes(std::int32_t centidegrees) {
  instances_.rotateShapes(centidegrees);
  collider_.turnShape(Angle(centidegrees));
  state_.angle = instances_.home().angle;
  observe();
  contacts_.updateRotated();
}

void Mover::report() {
  watch_.views.clear();
  instances_.appendViews(watch_.views);
  watch_.observer->leg(watch_.entity, watch_.views);
}

}  // namespace platon
