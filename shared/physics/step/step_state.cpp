#include "shared/physics/step/step_state.h"

#include <algorithm>

#include "platon/exact/integer.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/tolerances.h"

namespace platon {

void StepState::setDisplacement(PrecisePoint displacement) {
  tick = remaining = displacement;
  staysInRange = isFarFromLimit();
}

// Whether no instance can reach the coordinate limit in this step, in any frame. A rotation at most doubles the maxNorm
// of a displacement, and all nudges and roundings of a step are less than 2^12 subunits.
bool StepState::isFarFromLimit() const {
  constexpr std::int32_t kFar = kCoordinateLimit / 4 - (1 << 12);
  return maxNorm(tick) < kFar * PrecisePoint::kOne &&
         std::all_of(instances.all().begin(), instances.all().end(),
                     [](const Placement& placement) { return maxNorm(placement.position) < kFar; });
}

bool StepState::isEachInRange(Point home) const {
  return std::all_of(instances.all().begin(), instances.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

void StepState::moveTo(Point to) {
  const Point before = position();
  if (to == before) return;
  ++moves;
  instances.moveHomeTo(to);
  entity.position = to;
  observe();
  updateMoved(*this, before);
}

bool StepState::insertBehind(std::size_t placement, std::uint16_t warp) {
  if (!instances.insert(placement, warp, collider)) return false;
  staysInRange = staysInRange && isFarFromLimit();
  return true;
}

// The centre may have crossed several parts. Each rehome rotates the frame and with it the remaining displacement.
void StepState::rehome() {
  const auto onDrift = [&] {
    observe();
    updateContacts(*this);
  };
  for (;;) {
    PrecisePoint remainder = place - precise(position());
    const auto turn = instances.rehome(remainder, collider, onDrift);
    if (!turn) return;
    place = precise(position()) + remainder;
    instances.storeHome(entity);
    entity.heading = entity.heading + *turn;
    observe();
    rotateFrame(*turn);
  }
}

// The indices of the placements have changed with the frame.
void StepState::rotateFrame(Angle turn) {
  const Rotation rotation = rotationOf(turn);
  remaining = rotated(remaining, rotation);
  tick = rotated(tick, rotation);
  if (passing) passing->displacement = rotated(passing->displacement, rotation);
  contact.reset();
}

void StepState::dropUnreached() {
  if (!instances.dropUnreached(Tolerances::kDrop, collider)) return;
  observe();
  updateContacts(*this);
}

void StepState::rotateShapes(std::int32_t centidegrees) {
  instances.rotateShapes(centidegrees);
  collider.turnShape(Angle(centidegrees));
  entity.angle = instances.home().angle;
  observe();
  updateRotated(*this);
}

void StepState::report() {
  buffers.views.clear();
  instances.appendViews(buffers.views);
  observer->leg(id.index, buffers.views);
}

}  // namespace platon
