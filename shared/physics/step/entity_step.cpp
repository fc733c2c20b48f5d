#include "shared/physics/step/entity_step.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/sweep.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Whether a segment, of a wall or of a warp, is within Tolerances::kNear of the straight move.
bool isAnythingNear(const Placement& placement, Point displacement, Region& region, Region::Work& work) {
  Sweep sweep;
  sweep.start(*placement.shape, placement.position, displacement, Tolerances::kNear);
  region.cover(*placement.part, sweep.bounds().grown(Collider::kRegionMargin), work);
  for (std::size_t entry = 0; entry < region.segments().size(); ++entry) {
    if (region.mayOverlap(sweep, entry, *placement.shape)) return true;
  }
  return false;
}

}  // namespace

bool flyFreely(EntityState& state, Instances& instances, std::vector<Region>& regions, Region::Work& work) {
  constexpr std::int32_t kFar = kCoordinateLimit / 4;
  if (state.turn != 0 || !instances.isAlone() || instances.home().region >= regions.size()) return false;
  const PrecisePoint displacement = rotatePrecise(state.velocity, rotationOf(state.heading));
  if (maxNorm(displacement) <= Tolerances::kNoProgress || maxNorm(displacement) >= kFar * PrecisePoint::kOne ||
      maxNorm(state.position) >= kFar)
    return false;
  const PrecisePoint moved = displacement + PrecisePoint{state.remainder.x, state.remainder.y};
  const Point move = rounded(moved);
  const PrecisePoint remainder = moved - precise(move);
  // Of several nearest lattice points, `follow` chooses.
  if (maxNorm(remainder) >= PrecisePoint::kOne / 2) return false;
  Placement& home = instances.home();
  if (isAnythingNear(home, move, regions[home.region], work)) return false;
  instances.moveHomeTo(state.position + move);
  home.fresh = false;
  instances.storeHome(state);
  state.remainder = Point(static_cast<std::int32_t>(remainder.x), static_cast<std::int32_t>(remainder.y));
  return true;
}

namespace {

// Limit of one portion of a rotation, in centidegrees (5°). The arcs of the vertices then extend beyond the hull of the
// old and the new shape by less than 1/1000 of the radius.
constexpr std::int32_t kMaxPortion = 500;

// The first segment that blocks the rotation, in order of the instances starting at `from`.
std::optional<SegmentRef> blockerOf(StepState& step, std::int32_t centidegrees, std::size_t from) {
  Instances& instances = step.instances;
  for (std::size_t i = from; i < instances.all().size(); ++i) {
    const Placement& placement = instances.all()[i];
    const auto bounds = instances.rotationBounds(i, centidegrees);
    if (!bounds || !step.collider.mayOverlap(placement, *bounds)) continue;
    const Convex& hull = *instances.rotationHull(i, centidegrees);
    if (const auto segment = step.collider.overlapped(placement, hull)) return step.collider.refOf(placement, *segment);
  }
  return std::nullopt;
}

// Adds the instances that the rotating shape reaches. Returns false when one cannot be placed or the rotated shape is
// degenerate.
bool insertReachedBy(StepState& step, std::int32_t centidegrees) {
  Instances& instances = step.instances;
  for (std::size_t i = 0; i < instances.all().size(); ++i) {
    const auto bounds = instances.rotationBounds(i, centidegrees);
    if (!bounds) return false;
    const Box reach = bounds->grown(Tolerances::kInsert);
    const MapGeometry& part = *instances.all()[i].part;
    for (std::uint16_t warp = 0; warp < part.warps.size(); ++warp) {
      if (!reach.overlaps(boundsOf(part.warps[warp].from))) continue;
      const Convex& hull = *instances.rotationHull(i, centidegrees);
      if (!step.collider.reachesWarp(instances, {i, warp}, hull, Tolerances::kInsert)) continue;
      if (instances.isAtInstanceLimit(i) || !step.insertBehind(i, warp)) return false;
    }
  }
  return true;
}

bool rotatePortion(StepState& step, std::int32_t centidegrees) {
  const std::size_t known = step.instances.all().size();
  if (blockerOf(step, centidegrees, 0) || !insertReachedBy(step, centidegrees) || blockerOf(step, centidegrees, known))
    return false;
  step.rotateShapes(centidegrees);
  return true;
}

}  // namespace

// When a portion is blocked, smaller ones are tried, down to a centidegree, because the hull of a large portion is
// larger than the area that the shape sweeps. After a free portion the size doubles again.
void rotateBy(StepState& step, std::int32_t centidegrees) {
  std::int32_t limit = kMaxPortion;
  while (centidegrees != 0) {
    const std::int32_t portion = std::clamp(centidegrees, -limit, limit);
    if (rotatePortion(step, portion)) {
      centidegrees -= portion;
      limit = std::min(2 * limit, kMaxPortion);
    } else if (limit = std::abs(portion) / 2; limit == 0) {
      if (const auto segment = blockerOf(step, portion, 0)) addTouch(step, *segment);
      return;
    }
  }
}

namespace {

void storeRemainder(StepState& step) {
  const PrecisePoint remainder = step.place - precise(step.position());
  const bool isKept = maxNorm(remainder) <= kRemainderLimit;
  step.entity.remainder =
      isKept ? Point(static_cast<std::int32_t>(remainder.x), static_cast<std::int32_t>(remainder.y)) : Point();
}

// Instances are dropped only after all rehomes: a fast entity could otherwise leave the solid. And not while a contact
// names one.
void rehomeAndDrop(StepState& step) {
  step.rehome();
  if (!step.contact) step.dropUnreached();
}

// Passes the segment end that `end` touches, if it protrudes slightly from the edge of `from`, on which the ideal place
// is at `at`. The next leg leads on from there.
bool pass(StepState& step, const LegHit& end, const LegHit& from, PrecisePoint at, PrecisePoint remaining) {
  const auto nudge = findNudge(step, end, homeNormalOf(step.instances, from), at, remaining);
  if (!nudge) return false;
  step.moveTo(nudge->to);
  step.place = precise(nudge->to);
  step.remaining = remaining;
  step.contact.reset();
  step.passing = LegPlan{precise(nudge->onwards)};
  return true;
}

// A body that rests on a segment end may still pass it.
LegPlan nextPlan(StepState& step) {
  LegPlan plan = planLeg(step);
  if (plan.slides && plan.displacement == PrecisePoint() &&
      pass(step, *step.contact, *step.contact, step.place, step.remaining))
    plan = planLeg(step);
  step.passing.reset();
  if (!plan.slides) step.contact.reset();
  return plan;
}

// Whether the body is caught between the present contact and `hit`: the slide along each leads into the other, both are
// one edge, or there were too many slides without progress, of which this is one.
bool isWedged(StepState& step, const LegHit& hit) {
  return isOnContact(step, hit) || ++step.idleLegs > StepLimits::kMaxIdleLegs || isCaughtAt(step, hit);
}

// Between the present contact and `hit`, unless an end of one of them can be passed.
void stopInWedge(StepState& step, const LegHit& hit, PrecisePoint remaining) {
  const LegHit contact = *step.contact;
  const PrecisePoint place = step.place;
  if (pass(step, hit, contact, place, remaining) || pass(step, contact, hit, place, remaining) ||
      pass(step, hit, hit, place, remaining) || pass(step, contact, contact, place, remaining))
    return;
  addContact(step, hit);
  step.remaining = PrecisePoint();
}

// Moves to the end of the leg and reports the segment that stopped it.
void makeLeg(StepState& step, Leg& leg) {
  const PrecisePoint end = placeAfter(step, leg);
  const PrecisePoint remaining = remainingAfter(step, leg);
  const bool progresses = maxNorm(end - step.place) > Tolerances::kNoProgress;
  const bool isStopped = leg.isStopped();
  if (isStopped) turnCorner(step, *leg.hit, end);
  if (isStopped && !progresses && step.contact && isWedged(step, *leg.hit))
    return stopInWedge(step, *leg.hit, remaining);
  if (isStopped && isBlockedByEnd(step, *leg.hit, end, remaining) &&
      pass(step, *leg.hit, step.contact ? *step.contact : *leg.hit, end, remaining))
    return;
  const bool isNear = maxNorm(end - precise(step.position())) <= Tolerances::kContactGap * PrecisePoint::kOne;
  const Point start = step.position();
  // A leg that has no room for another instance would be repeated.
  step.remaining = leg.end == Leg::End::kFull && !progresses ? PrecisePoint() : remaining;
  step.contact.reset();
  if (progresses) step.idleLegs = 0;
  if ((!progresses && isNear) || follow(step, end, leg.hit ? &*leg.hit : nullptr)) {
    if (progresses || leg.plan.cut) step.place = end;
    if (isStopped) step.contact = leg.hit;
  } else if (fallBack(step, end) || step.position() != start) {
    step.place = precise(step.position());
  } else {
    step.remaining = PrecisePoint();  // so the next tick ends in the same way
  }
  if (isStopped) addContact(step, *leg.hit);
  if (isStopped && leg.hit->placement == 0 && step.touched == Collider::kNoSegment) step.touched = leg.hit->segment;
}

// The first two legs of a body that still slides along the segment of the last step: one that is stopped at once, for
// which no search is needed, and one along the edge. Returns false, and moves nothing, in other cases.
bool continueSlide(StepState& step) {
  const std::uint32_t touched = std::exchange(step.touched, Collider::kNoSegment);
  const bool isNear =
      maxNorm(step.place - precise(step.position())) < (Tolerances::kContactGap - 1) * PrecisePoint::kOne;
  if (touched == Collider::kNoSegment || !isNear || !step.instances.isAlone()) return false;
  const auto hit = step.collider.touching(step.instances, touched, step.place, step.remaining);
  if (!hit || isBlockedByEnd(step, *hit, step.place, step.remaining)) return false;
  step.contact = hit;
  const LegPlan plan = planLeg(step);
  auto leg = plan.displacement == PrecisePoint() ? std::nullopt : findSlide(step, plan);
  if (!leg) {
    step.contact.reset();
    return false;
  }
  step.touched = touched;
  addContact(step, *hit);
  makeLeg(step, *leg);
  if (!step.instances.isAlone()) rehomeAndDrop(step);
  return true;
}

// The displacement of the tick does not change during slides: a segment removes only the component towards it, and only
// while it touches.
void translate(StepState& step, Point velocity, Angle heading) {
  step.setDisplacement(rotatePrecise(velocity, rotationOf(heading)));
  if (velocity == Point()) {  // a rotation may have brought the shape to other edges
    insertReachedInstances(step);
    return;
  }
  for (int legs = continueSlide(step) ? 2 : 0;
       legs < StepLimits::kMaxLegs && step.moves <= StepLimits::kMaxLegs - StepLimits::kMovesOfLeg &&
       step.remaining != PrecisePoint();
       ++legs) {
    const LegPlan plan = nextPlan(step);
    if (plan.displacement == PrecisePoint()) break;
    Leg leg = findLeg(step, plan);
    makeLeg(step, leg);
    if (!step.instances.isAlone()) rehomeAndDrop(step);
  }
  if (step.contact) step.dropUnreached();
  storeRemainder(step);
}

}  // namespace

bool insertReachedInstances(StepState& step) {
  const Leg leg = findLeg(step, {});
  rehomeAndDrop(step);
  storeRemainder(step);
  return leg.end == Leg::End::kReached && !leg.lacksInstance;
}

void takeStep(StepState& step, std::vector<InstanceState>& further) {
  beginContacts(step);
  rotateBy(step, std::exchange(step.entity.turn, 0));
  translate(step, step.entity.velocity, step.entity.heading);
  step.instances.reuseIds(step.firstId);
  finishContacts(step);
  step.store(further);
}

}  // namespace platon
