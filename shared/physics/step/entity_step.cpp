#include "shared/physics/step/entity_step.h"

#include <algorithm>
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/turned_normal.h"

namespace platon {

EntityStep::EntityStep(Entity entity, EntityState& state, Instances& instances, const Context& context)
    : entity_(entity),
      state_(state),
      events_(context.events),
      firstEvent_(context.events.size()),
      headingBefore_(state.heading),
      observer_(context.observer),
      ideal_(precise(state.position) + PrecisePoint{state.remainder.x, state.remainder.y}),
      instances_(instances),
      collider_(context.buffers.collider),
      refusedWarps_(context.buffers.refusedWarps),
      changes_(context.buffers.changes),
      views_(context.buffers.views) {
  collider_.begin(context.rules, entity, instances, context.regions, context.work);
  observe();
}

// tick_ does not change during slides: a segment removes only the component towards it, and only while it touches.
void EntityStep::translate(Point velocity, Angle heading) {
  tick_ = rest_ = rotatePrecise(velocity, rotationOf(heading));
  staysInRange_ = staysInRange();
  if (velocity == Point()) {  // a rotation may have brought the shape to other edges
    Leg leg;
    prepareLeg(leg);
    rehome();
    storeRemainder();
    return;
  }
  for (int legs = 0; legs < kMaxLegs && moves_ <= kMaxLegs - kMovesOfLeg && rest_ != PrecisePoint(); ++legs) {
    const LegPlan plan = planLeg();
    if (plan.displacement == PrecisePoint()) break;
    Leg leg{plan.displacement, plan.slides};
    prepareLeg(leg);
    executeLeg(leg, plan);
    if (!instances_.isAlone()) rehome();
  }
  if (contact_) dropUnreached();
  storeRemainder();
}

void EntityStep::storeRemainder() {
  const PrecisePoint remainder = ideal_ - precise(position());
  const bool isKept = maxNorm(remainder) <= kRemainderLimit;
  state_.remainder =
      isKept ? Point(static_cast<std::int32_t>(remainder.x), static_cast<std::int32_t>(remainder.y)) : Point();
}

bool EntityStep::insertReachedInstances() {
  Leg leg;
  prepareLeg(leg);
  rehome();
  storeRemainder();
  return leg.end == End::kReached && refusedWarps_.empty();
}

void EntityStep::finish(std::vector<InstanceState>& further) {
  updateContacts();
  if (!collider_.overlapped().empty()) addOver();
  clearFresh();
  events_.turnHome(firstEvent_, state_.heading - headingBefore_);
  store(further);
}

// Instances are inserted before the leg, while their shape is still outside the part and therefore free.
void EntityStep::prepareLeg(Leg& leg) {
  refusedWarps_.clear();
  clampToRange(leg);
  findHit(leg);
  if (!collider_.isNearWarps(instances_)) return;
  const std::size_t before = instances_.all().size();
  while (leg.end == End::kReached || leg.end == End::kStopped) {
    const auto warpHit =
        collider_.firstWarp(instances_, {position(), leg.target, Tolerances::kInsert}, leg.hit, refusedWarps_);
    if (!warpHit) break;
    insertInstanceBehind(leg, *warpHit);
  }
  if (instances_.all().size() != before) observe();
}

void EntityStep::findHit(Leg& leg) {
  leg.hit.reset();
  collider_.startLeg(instances_, leg.target);
  findHit(leg, 0);
  for (std::size_t i = 1; i < instances_.all().size(); ++i) findHit(leg, i);
  leg.end = leg.hit ? End::kStopped : End::kReached;
}

void EntityStep::findHit(Leg& leg, std::size_t index) {
  const PrecisePoint displacement =
      index == 0 ? leg.displacement : rotated(leg.displacement, instances_.all()[index].fromHome);
  const bool slidesHere = leg.slides && contact_->placement == index;
  collider_.firstIdeal(instances_, index, instances_.idealOf(index, ideal_), displacement, leg.hit,
                       slidesHere ? contact_->segment : Collider::kNoSegment);
}

// Shortens the displacement until all instances stay within the coordinate limit. Returns whether it was too long.
bool EntityStep::clampToRange(Leg& leg) const {
  leg.target = roundedAt(ideal_ + leg.displacement);
  bool clamped = false;
  for (; leg.target != position() && !allInRange(leg.target); clamped = true) {
    leg.displacement = {leg.displacement.x / 2, leg.displacement.y / 2};
    leg.share.denominator *= 2;
    leg.target = roundedAt(ideal_ + leg.displacement);
  }
  return clamped;
}

void EntityStep::insertInstanceBehind(Leg& leg, const LegHit& warpHit) {
  const auto warp =
      static_cast<std::uint16_t>(instances_.all()[warpHit.placement].part->warpOfSegment(warpHit.segment));
  if (instances_.isAtInstanceLimit(warpHit.placement)) {
    stopAtWarp(leg, warpHit, End::kFull);
  } else if (instances_.insert(warpHit.placement, warp, collider_)) {
    staysInRange_ = staysInRange_ && staysInRange();
    if (clampToRange(leg)) {  // the new instance reaches the coordinate limit earlier
      findHit(leg);
    } else {
      findHit(leg, instances_.all().size() - 1);
      leg.end = leg.hit ? End::kStopped : End::kReached;
    }
  } else if (movesAwayFromWarp(warpHit, leg.target)) {
    refusedWarps_.push_back({warpHit.placement, warp});
  } else {
    stopAtWarp(leg, warpHit, End::kRefused);
  }
}

// The ideal place stops where the lattice position would.
void EntityStep::stopAtWarp(Leg& leg, const LegHit& warpHit, End end) {
  leg.end = end;
  leg.hit = warpHit;
  const Point normal = normalOf(warpHit);
  const PrecisePoint place = instances_.idealOf(warpHit.placement, ideal_ + scaled(leg.displacement, warpHit.hit.time));
  const int128 along = distanceTo({normal, 0}, place);
  const Obstacle::HalfPlane half{normal, -static_cast<std::int64_t>(divideRounded(along, int128{PrecisePoint::kOne}))};
  const Placement& placement = instances_.all()[warpHit.placement];
  leg.hit->edge = edgeOf(*placement.shape, placement.part->segments[warpHit.segment], half);
}

// Whether the leg leads away from the warp segment or along it. It then does not need the instance behind the warp.
bool EntityStep::movesAwayFromWarp(const LegHit& warpHit, Point target) const {
  const Placement& placement = instances_.all()[warpHit.placement];
  const Segment& segment = placement.part->segments[warpHit.segment];
  return dot(perpendicular(segment.b - segment.a), placement.at(target) - placement.position) >= 0;
}

bool EntityStep::isEachInRange(Point home) const {
  return std::all_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

// Whether no instance can reach the coordinate limit in this step, in any frame. A rotation at most doubles the maxNorm
// of a displacement, and all nudges and roundings of a step are less than 2^12 subunits.
bool EntityStep::staysInRange() const {
  constexpr std::int32_t kNear = kCoordinateLimit / 4 - (1 << 12);
  return maxNorm(rest_) < kNear * PrecisePoint::kOne &&
         std::all_of(instances_.all().begin(), instances_.all().end(),
                     [](const Placement& placement) { return maxNorm(placement.position) < kNear; });
}

// Moves to the end of the leg and reports the segment that stopped it.
void EntityStep::executeLeg(Leg& leg, const LegPlan& plan) {
  const PrecisePoint end = endOf(leg, plan);
  const PrecisePoint rest = restAfter(leg, plan);
  const bool progresses = maxNorm(end - ideal_) > Tolerances::kNoProgress;
  const bool isStopped = leg.hit && leg.end != End::kFull;
  if (isStopped) turnCorner(*leg.hit, end);
  if (isStopped && !progresses && contact_ && isWedged(*leg.hit)) return stopInWedge(*leg.hit, rest);
  if (isStopped && isBlockedByEnd(*leg.hit, end, rest) &&
      passEnd(*leg.hit, homeNormalOf(contact_ ? *contact_ : *leg.hit), end, rest))
    return;
  const Point start = position();
  const bool isNear = maxNorm(end - precise(start)) <= Tolerances::kContactGap * PrecisePoint::kOne;
  rest_ = rest;
  contact_.reset();
  if (progresses) idleLegs_ = 0;
  if ((!progresses && isNear) || follow(end, leg)) {
    if (progresses || plan.cut) ideal_ = end;
    if (isStopped) contact_ = leg.hit;
  } else if (!fallBack(end)) {
    rest_ = PrecisePoint();
  }
  if (isStopped) addContact(*leg.hit);
}

// Between the present contact and `hit`, unless an end of one of them can be passed.
void EntityStep::stopInWedge(const LegHit& hit, PrecisePoint rest) {
  const LegHit contact = *contact_;
  if (passEnd(hit, homeNormalOf(contact), ideal_, rest) || passEnd(contact, homeNormalOf(hit), ideal_, rest) ||
      passEnd(hit, homeNormalOf(hit), ideal_, rest) || passEnd(contact, homeNormalOf(contact), ideal_, rest))
    return;
  addContact(hit);
  rest_ = PrecisePoint();
}

PrecisePoint EntityStep::endOf(const Leg& leg, const LegPlan& plan) const {
  PrecisePoint end = ideal_ + (leg.hit ? scaled(leg.displacement, leg.hit->hit.time) : leg.displacement);
  if (plan.slides) end = onto(*contact_, end);
  return leg.hit ? onto(*leg.hit, end) : end;
}

// The home place `place`, moved so that the ideal place of the instance that hit the edge is not inside of it.
PrecisePoint EntityStep::onto(const LegHit& hit, PrecisePoint place) const {
  if (hit.placement == 0) return putOnto(hit.edge.half, place);
  const PrecisePoint there = instances_.idealOf(hit.placement, place);
  return place + toHome(hit, putOnto(hit.edge.half, there) - there);
}

PrecisePoint EntityStep::restAfter(const Leg& leg, const LegPlan& plan) const {
  const Fraction time = leg.hit ? leg.hit->hit.time : Fraction{1, 1};
  return rest_ - scaled(scaled(scaled(rest_, plan.share), leg.share), time);
}

// The normal of a hit. For a warp segment that the shape with margin overlaps already: the direction into its part.
Point EntityStep::normalOf(const LegHit& hit) const {
  if (hit.hit.side != Hit::Side::kInside) return hit.hit.normal;
  const Segment& segment = instances_.all()[hit.placement].part->segments[hit.segment];
  return perpendicular(segment.b - segment.a);
}

Point EntityStep::homeNormalOf(const LegHit& hit) const {
  const Point normal = normalOf(hit);
  return hit.placement == 0 ? normal : turnedNormal(normal, instances_.all()[hit.placement].toHome);
}

// The centre may have crossed several parts. Each rehome rotates the frame and with it the remaining displacement.
// Instances are dropped only afterwards: a fast entity could otherwise leave the solid.
void EntityStep::rehome() {
  while (instances_.needsRehome()) {
    if (instances_.correctDrift(collider_)) observe();
    PrecisePoint remainder = ideal_ - precise(position());
    const auto turn = instances_.rehome(remainder);
    if (!turn) break;
    ideal_ = precise(position()) + remainder;
    rotateFrame(*turn);
    instances_.storeHome(state_);
    state_.heading = state_.heading + *turn;
    observe();
  }
  if (!contact_) dropUnreached();
}

void EntityStep::dropUnreached() {
  if (!instances_.dropUnreached(Tolerances::kDrop, collider_)) return;
  observe();
  updateContacts();
}

void EntityStep::rotateFrame(Angle turn) {
  const Rotation rotation = rotationOf(turn);
  rest_ = rotated(rest_, rotation);
  tick_ = rotated(tick_, rotation);
  if (planAfterNudge_) planAfterNudge_->displacement = rotated(planAfterNudge_->displacement, rotation);
  contact_.reset();  // the indices of the placements have changed
}

void EntityStep::moveTo(Point position) {
  const Point before = this->position();
  if (position == before) return;
  ++moves_;
  instances_.moveHomeTo(position);
  state_.position = position;
  observe();
  followContacts(before);
}

void EntityStep::report() {
  views_.clear();
  instances_.appendViews(views_);
  observer_->leg(entity_.index(), views_);
}

}  // namespace platon
