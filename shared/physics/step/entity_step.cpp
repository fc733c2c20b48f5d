#include "shared/physics/step/entity_step.h"

#include <utility>

#include "shared/physics/step/follow.h"
#include "shared/physics/step/hit_frame.h"
#include "shared/physics/step/segment_ends.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

Collider& begun(const Entity& entity, const Instances& instances, const EntityStep::Context& context) {
  context.buffers.collider.begin(context.rules, entity, instances, context.regions, context.work);
  return context.buffers.collider;
}

}  // namespace

EntityStep::EntityStep(const Entity& entity, EntityState& state, Instances& instances, const Context& context)
    : state_(state),
      headingBefore_(state.heading),
      firstId_(state.nextId),
      touched_(context.touched),
      refusedWarps_(context.buffers.refusedWarps),
      contacts_(entity.id(), instances, begun(entity, instances, context), context.events, context.buffers.changes),
      mover_(state, instances, context.buffers.collider, contacts_,
             {context.observer, entity.index(), context.buffers.views}),
      slide_{instances, precise(state.position) + PrecisePoint{state.remainder.x, state.remainder.y}} {}

// The displacement of the tick does not change during slides: a segment removes only the component towards it, and only
// while it touches.
void EntityStep::translate(Point velocity, Angle heading) {
  slide_.tick = slide_.remaining = rotatePrecise(velocity, rotationOf(heading));
  mover_.start(slide_.remaining);
  if (velocity == Point()) {  // a rotation may have brought the shape to other edges
    insertReachedInstances();
    return;
  }
  for (int legs = slideOn() ? 2 : 0;
       legs < kMaxLegs && mover_.moves() <= kMaxLegs - kMovesOfLeg && slide_.remaining != PrecisePoint(); ++legs) {
    const LegPlan plan = nextPlan();
    if (plan.displacement == PrecisePoint()) break;
    Leg leg{plan.displacement};
    prepareLeg(leg, mover_, slide_.place, plan.slides ? &*slide_.contact : nullptr, refusedWarps_);
    executeLeg(leg, plan);
    if (!mover_.instances().isAlone()) rehome();
  }
  if (slide_.contact) mover_.dropUnreached();
  storeRemainder();
}

// The first two legs of a body that still slides along the segment of the last step: one that is stopped at once, for
// which no search is needed, and one along the edge. Returns false, and does nothing, in other cases.
bool EntityStep::slideOn() {
  const std::uint32_t touched = std::exchange(touched_, Collider::kNoSegment);
  const bool isNear =
      maxNorm(slide_.place - precise(mover_.position())) < (Tolerances::kContactGap - 1) * PrecisePoint::kOne;
  if (touched == Collider::kNoSegment || !isNear || !mover_.instances().isAlone()) return false;
  const auto hit = mover_.collider().touching(mover_.instances(), touched, slide_.place, slide_.remaining);
  if (!hit || isBlockedByEnd(slide_, *hit, slide_.place, slide_.remaining)) return false;
  slide_.contact = hit;
  const LegPlan plan = slide_.next();
  Leg leg{plan.displacement};
  if (plan.displacement == PrecisePoint() ||
      !prepareSlide(leg, mover_, slide_.place, *hit, slide_.remaining, refusedWarps_)) {
    slide_.contact.reset();
    return false;
  }
  touched_ = touched;
  contacts_.addContact(*hit);
  executeLeg(leg, plan);
  if (!mover_.instances().isAlone()) rehome();
  return true;
}

bool EntityStep::insertReachedInstances() {
  Leg leg;
  prepareLeg(leg, mover_, slide_.place, nullptr, refusedWarps_);
  rehome();
  storeRemainder();
  return leg.end == Leg::End::kReached && refusedWarps_.empty();
}

// A body that rests on a segment end may still pass it.
LegPlan EntityStep::nextPlan() {
  LegPlan plan = slide_.next();
  if (plan.slides && plan.displacement == PrecisePoint() &&
      pass(*slide_.contact, *slide_.contact, slide_.place, slide_.remaining))
    plan = slide_.next();
  slide_.passing.reset();
  if (!plan.slides) slide_.contact.reset();
  return plan;
}

// Moves to the end of the leg and reports the segment that stopped it.
void EntityStep::executeLeg(Leg& leg, const LegPlan& plan) {
  const PrecisePoint end = slide_.endOf(leg, plan);
  const PrecisePoint remaining = slide_.remainingAfter(leg, plan);
  const bool progresses = maxNorm(end - slide_.place) > Tolerances::kNoProgress;
  const bool isStopped = leg.isStopped();
  if (isStopped) slide_.turnCorner(*leg.hit, end);
  if (isStopped && !progresses && slide_.contact && isWedged(*leg.hit)) return stopInWedge(*leg.hit, remaining);
  if (isStopped && isBlockedByEnd(slide_, *leg.hit, end, remaining) &&
      pass(*leg.hit, slide_.contact ? *slide_.contact : *leg.hit, end, remaining))
    return;
  const bool isNear = maxNorm(end - precise(mover_.position())) <= Tolerances::kContactGap * PrecisePoint::kOne;
  const Point start = mover_.position();
  // A leg that has no room for another instance would be repeated.
  slide_.remaining = leg.end == Leg::End::kFull && !progresses ? PrecisePoint() : remaining;
  slide_.contact.reset();
  if (progresses) idleLegs_ = 0;
  if ((!progresses && isNear) || follow(mover_, {end, leg.hit ? &*leg.hit : nullptr, slide_.tick})) {
    if (progresses || plan.cut) slide_.place = end;
    if (isStopped) slide_.contact = leg.hit;
  } else if (fallBack(mover_, end) || mover_.position() != start) {
    slide_.place = precise(mover_.position());
  } else {
    slide_.remaining = PrecisePoint();  // so the next tick ends in the same way
  }
  if (isStopped) contacts_.addContact(*leg.hit);
  if (isStopped && leg.hit->placement == 0 && touched_ == Collider::kNoSegment) touched_ = leg.hit->segment;
}

// Whether the body is caught between the present contact and `hit`: the slide along each leads into the other, both are
// one edge, or there were too many slides without progress, of which this is one.
bool EntityStep::isWedged(const LegHit& hit) {
  return slide_.isOnContact(hit) || ++idleLegs_ > kMaxIdleLegs || slide_.isCaughtAt(hit);
}

// Between the present contact and `hit`, unless an end of one of them can be passed.
void EntityStep::stopInWedge(const LegHit& hit, PrecisePoint remaining) {
  const LegHit contact = *slide_.contact;
  const PrecisePoint place = slide_.place;
  if (pass(hit, contact, place, remaining) || pass(contact, hit, place, remaining) ||
      pass(hit, hit, place, remaining) || pass(contact, contact, place, remaining))
    return;
  contacts_.addContact(hit);
  slide_.remaining = PrecisePoint();
}

// Passes the segment end that `end` touches, if it protrudes slightly from the edge of `from`, on which the ideal place
// is at `place`. The next leg leads on from there.
bool EntityStep::pass(const LegHit& end, const LegHit& from, PrecisePoint place, PrecisePoint remaining) {
  const auto nudge = findNudge(mover_, slide_, end, homeNormalOf(mover_.instances(), from), place, remaining);
  if (!nudge) return false;
  mover_.moveTo(nudge->to);
  slide_.place = precise(nudge->to);
  slide_.remaining = remaining;
  slide_.contact.reset();
  slide_.passing = LegPlan{precise(nudge->onwards)};
  return true;
}

// The centre may have crossed several parts. Each rehome rotates the frame and with it the remaining displacement.
// Instances are dropped only afterwards: a fast entity could otherwise leave the solid.
void EntityStep::rehome() {
  while (const auto turn = mover_.rehome(slide_.place)) slide_.rotateFrame(*turn);
  if (!slide_.contact) mover_.dropUnreached();
}

void EntityStep::storeRemainder() {
  const PrecisePoint remainder = slide_.place - precise(mover_.position());
  const bool isKept = maxNorm(remainder) <= kRemainderLimit;
  state_.remainder =
      isKept ? Point(static_cast<std::int32_t>(remainder.x), static_cast<std::int32_t>(remainder.y)) : Point();
}

void EntityStep::finish(std::vector<InstanceState>& further) {
  mover_.instances().reuseIds(firstId_);
  contacts_.finish(state_.heading - headingBefore_);
  store(further);
}

}  // namespace platon
