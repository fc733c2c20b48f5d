#include "shared/physics/entity_step.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/slide.h"

namespace platon {
namespace {

// An instance is dropped only at this distance from its warp segment, in subunits. Larger than the margin of insertion,
// so that instances are not dropped and inserted alternately.
constexpr std::int32_t kDropMargin = 8;

Point halved(Point displacement) { return {displacement.x / 2, displacement.y / 2}; }

}  // namespace

void EntityStep::begin(Entity entity, EntityState& state, std::span<const InstanceState> further,
                       const Context& context) {
  entity_.emplace(entity);
  state_ = &state;
  rules_ = &context.rules;
  observer_ = context.observer;
  instances_.load(context.geometry, context.shapes, context.base, state, further);
  collider_.begin(context.rules, entity, context.regions, context.work);
  tickDisplacement_ = remaining_ = Point();
  remainder_ = {state.remainder.x, state.remainder.y};
  unobstructed_ = true;
  stop_.reset();
  previousStop_.reset();
  lastSlide_.reset();
  planAfterNudge_.reset();
  contacts_.clear();
  observe();
}

// tickDisplacement_ does not change during slides: a segment removes only the component towards it, and only while it
// touches.
void EntityStep::translate(Point velocity, Angle heading) {
  startTranslation(velocity, heading);
  for (int legs = 0; legs < kMaxLegs; ++legs) {
    const LegPlan plan = planLeg();
    if (legs != 0 && plan.uncut == Point()) break;
    const Leg leg = prepareLeg(clampToRange(position() + plan.displacement));
    const bool moves = leg.target != position();
    executeLeg(leg, plan);
    rehome();
    if (remaining_ == Point() || !moves) break;
  }
  if (stop_ && instances_.dropUnreached(kDropMargin, collider_)) observe();
  storeRemainder();
}

// Without velocity, a remainder does not move the entity (I4).
void EntityStep::startTranslation(Point velocity, Angle heading) {
  if (velocity == Point()) return;
  const PrecisePoint exact = rotatePrecise(velocity, rotationOf(heading)) + remainder_;
  tickDisplacement_ = remaining_ = rounded(exact);
  remainder_ = exact - precise(remaining_);
}

// Discards the remainder after a contact.
void EntityStep::storeRemainder() {
  const bool isKept = unobstructed_ && remaining_ == Point() &&
                      std::max(std::abs(remainder_.x), std::abs(remainder_.y)) <= kRemainderLimit;
  state_->remainder =
      isKept ? Point(static_cast<std::int32_t>(remainder_.x), static_cast<std::int32_t>(remainder_.y)) : Point();
}

bool EntityStep::insertReachedInstances() {
  const Leg leg = prepareLeg(position());
  rehome();
  return leg.end == End::kReached && refusedWarps_.empty();
}

void EntityStep::finish(std::vector<InstanceState>& further) {
  callOver();
  store(further);
}

// Instances are inserted before the leg, while their shape is still outside the part and therefore free.
EntityStep::Leg EntityStep::prepareLeg(Point target) {
  refusedWarps_.clear();
  const std::size_t before = instances_.all().size();
  Leg leg{target, End::kReached, collider_.first(instances_, position(), target)};
  if (leg.hit) leg.end = End::kStopped;
  while (leg.end == End::kReached || leg.end == End::kStopped) {
    const auto warpHit =
        collider_.firstWarp(instances_, {position(), leg.target, kInsertMargin}, leg.hit, refusedWarps_);
    if (!warpHit) break;
    insertInstanceBehind(leg, *warpHit);
  }
  if (instances_.all().size() != before) observe();
  return leg;
}

void EntityStep::insertInstanceBehind(Leg& leg, const LegHit& warpHit) {
  const auto warp =
      static_cast<std::uint16_t>(instances_.all()[warpHit.placement].part->warpOfSegment(warpHit.segment));
  if (instances_.isAtInstanceLimit(warpHit.placement)) {
    leg.end = End::kFull;
    leg.hit = warpHit;
  } else if (instances_.insert(warpHit.placement, warp, collider_)) {
    const Point target = clampToRange(leg.target);
    if (target == leg.target) {
      collider_.first(instances_, instances_.all().size() - 1, position(), target, leg.hit);
    } else {  // the new instance reaches the coordinate limit earlier
      leg.target = target;
      leg.hit = collider_.first(instances_, position(), target);
    }
    leg.end = leg.hit ? End::kStopped : End::kReached;
  } else if (movesAwayFromWarp(warpHit, leg.target)) {
    refusedWarps_.push_back({warpHit.placement, warp});
  } else {
    leg.end = End::kRefused;
    leg.hit = warpHit;
  }
}

// Whether the leg leads away from the warp segment or along it. It then does not need the instance behind the warp.
bool EntityStep::movesAwayFromWarp(const LegHit& warpHit, Point target) const {
  const Placement& placement = instances_.all()[warpHit.placement];
  const Segment& segment = placement.part->segments[warpHit.segment];
  return dot(perpendicular(segment.b - segment.a), placement.at(target) - placement.position) >= 0;
}

// Shortens a displacement until all instances stay within the coordinate limit.
Point EntityStep::clampToRange(Point target) const {
  while (target != position() && !allInRange(target)) target = position() + halved(target - position());
  return target;
}

bool EntityStep::allInRange(Point home) const {
  if (isFarFromLimit(home)) return true;
  return std::all_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& placement) {
    const Point at = placement.at(home);
    return isCoordinate(at.x) && isCoordinate(at.y);
  });
}

// Fast path of allInRange: whether the positions and the displacement are so small that no instance can reach the
// coordinate limit in any frame. A rotation at most doubles the maxNorm of a displacement.
bool EntityStep::isFarFromLimit(Point home) const {
  constexpr std::int32_t kNear = kCoordinateLimit / 4;
  if (maxNorm(home - position()) >= kNear) return false;
  return std::all_of(instances_.all().begin(), instances_.all().end(),
                     [](const Placement& placement) { return maxNorm(placement.position) < kNear; });
}

// Moves to the end of the leg and reports the segment that stopped it.
void EntityStep::executeLeg(const Leg& leg, const LegPlan& plan) {
  if (leg.end == End::kReached) {
    const Point end = stop_ ? stopBeforeReversal(leg.target) : leg.target;
    const bool stays = end == position();
    moveAlong(plan, end);
    if (stays) remaining_ = Point();
    return;
  }
  const Point displacement = leg.target - position();
  const Point reached = position() + scaleTruncated(displacement, leg.hit->hit.time);
  if (leg.end == End::kStopped && tryPassEnd(leg, plan, reached)) return;
  const Point end = contactPosition(*leg.hit, displacement);
  if (leg.end == End::kStopped && stop_ && isWedge(*leg.hit, end)) {
    stopInWedge(*leg.hit, plan);
    return;
  }
  moveAlong(plan, end);
  if (leg.end == End::kFull) return;
  unobstructed_ = false;
  callContact(*leg.hit);
  previousStop_ = std::exchange(stop_, leg.hit);
}

void EntityStep::moveAlong(const LegPlan& plan, Point end) {
  const Point start = position();
  moveTo(end);
  callPierced(start);
  remaining_ = remainingAfter(plan, end - start);
}

Point EntityStep::remainingAfter(const LegPlan& plan, Point moved) const {
  return remaining_ - (plan.slides ? scaleTruncated(remaining_, fractionCovered(moved, plan.uncut)) : moved);
}

// The lattice point at which a hit stops the home instance. The truncated contact point can be inside the obstacle by
// up to a subunit, so it is only a candidate, as are the points one and two steps along the dominant axis of the
// normal, which are outside the entered edge. When none is free, shorter moves are tried, and finally no move.
Point EntityStep::contactPosition(const LegHit& hit, Point displacement) {
  const Point outwards = dominantStep(homeNormalOf(hit));
  Point move = scaleTruncated(displacement, hit.hit.time);
  while (move != Point()) {
    if (const auto free = firstFree(position() + move, outwards, displacement)) return *free;
    move = halved(move);
  }
  return position();
}

std::optional<Point> EntityStep::firstFree(Point candidate, Point outwards, Point displacement) {
  for (int steps = 0; steps <= 2; ++steps, candidate += outwards) {
    if (dot(candidate - position(), displacement) <= 0) continue;
    if (allInRange(candidate) && collider_.isFree(instances_, position(), candidate)) return candidate;
  }
  return std::nullopt;
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
    const auto turn = instances_.rehome(remainder_);
    if (!turn) break;
    rotateFrame(*turn);
    instances_.storeHome(*state_);
    state_->heading = state_->heading + *turn;
    observe();
  }
  if (!stop_ && instances_.dropUnreached(kDropMargin, collider_)) observe();
}

void EntityStep::rotateFrame(Angle turn) {
  const Rotation rotation = rotationOf(turn);
  const PrecisePoint remaining = rotatePrecise(remaining_, rotation) + remainder_;
  remaining_ = remaining_ == Point() ? Point() : rounded(remaining);
  remainder_ = remaining - precise(remaining_);
  tickDisplacement_ = rotate(tickDisplacement_, rotation);
  if (planAfterNudge_)
    planAfterNudge_ = LegPlan{rotate(planAfterNudge_->displacement, rotation), rotate(planAfterNudge_->uncut, rotation),
                              planAfterNudge_->slides};
  stop_.reset();  // the indices of the placements have changed
  previousStop_.reset();
  lastSlide_.reset();
}

void EntityStep::moveTo(Point position) {
  if (position == this->position()) return;
  instances_.moveHomeTo(position);
  state_->position = position;
  stop_.reset();
  previousStop_.reset();
  observe();
}

void EntityStep::observe() {
  if (observer_ == nullptr) return;
  views_.clear();
  instances_.appendViews(views_);
  observer_->leg(entity_->index(), views_);
}

}  // namespace platon
