#include <cassert>

#include "platon/exact/integer.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// Whether the slides of the remaining displacement and of the whole tick along the edge are too short to be slides.
bool restsOn(const StepState& step, const LegHit& hit) {
  const Point normal = hit.edge.half.normal;
  return maxNorm(alongEdge(normal, fromHome(step.instances, hit, step.remaining))) < Tolerances::kRest &&
         maxNorm(alongEdge(normal, fromHome(step.instances, hit, step.tick))) < Tolerances::kRest;
}

LegPlan planSlide(const StepState& step) {
  const LegHit& contact = *step.contact;
  const EdgeSlide along = slideFrom(step, contact, step.place, step.remaining);
  if (maxNorm(along.displacement) < Tolerances::kRest && restsOn(step, contact)) return {{}, {1, 1}, true};
  return {toHome(step.instances, contact, along.displacement), along.share, true, along.cut};
}

}  // namespace

// Where the place is already at the end of the edge, the path leads past the corner.
LegPlan planLeg(const StepState& step) {
  if (step.passing) return *step.passing;
  const auto& contact = step.contact;
  if (contact && distanceTo({contact->edge.half.normal, 0}, fromHome(step.instances, *contact, step.remaining)) < 0) {
    const LegPlan plan = planSlide(step);
    if (!plan.cut || plan.displacement != PrecisePoint()) return plan;
  }
  return {step.remaining};
}

namespace {

// Shortens the displacement until all instances stay within the coordinate limit. Returns whether it was too long.
bool clampToRange(const StepState& step, Leg& leg) {
  leg.target = step.roundedAt(step.place + leg.displacement);
  bool clamped = false;
  for (; leg.target != step.position() && !step.allInRange(leg.target); clamped = true) {
    leg.displacement = {leg.displacement.x / 2, leg.displacement.y / 2};
    leg.share.denominator *= 2;
    leg.target = step.roundedAt(step.place + leg.displacement);
    if (leg.displacement == PrecisePoint()) {  // a contact has put the ideal place itself out of range
      leg.target = step.position();
      leg.share = {1, 1};  // nothing is left of the displacement, or the leg would be repeated
    }
  }
  return clamped;
}

// Of placement `index`, if it is earlier than what was found.
void findHit(StepState& step, Leg& leg, std::size_t index) {
  const Instances& instances = step.instances;
  const PrecisePoint displacement =
      index == 0 ? leg.displacement : rotated(leg.displacement, instances.all()[index].fromHome);
  const bool slidesHere = leg.plan.slides && step.contact->placement == index;
  step.collider.firstIdeal(instances, index, instances.idealOf(index, step.place), displacement, leg.hit,
                           slidesHere ? step.contact->segment : Collider::kNoSegment);
  leg.end = leg.hit ? Leg::End::kStopped : Leg::End::kReached;
}

// The earliest of any instance.
void findHit(StepState& step, Leg& leg) {
  leg.hit.reset();
  step.collider.startLeg(step.instances, leg.target);
  for (std::size_t i = 0; i < step.instances.all().size(); ++i) findHit(step, leg, i);
}

// The ideal place stops where the lattice position would.
void stopAtWarp(const StepState& step, Leg& leg, const LegHit& warpHit, Leg::End end) {
  leg.end = end;
  leg.hit = warpHit;
  const Instances& instances = step.instances;
  const Point normal = normalOf(instances, warpHit);
  const PrecisePoint at = instances.idealOf(warpHit.placement, step.place + scaled(leg.displacement, warpHit.hit.time));
  const int128 along = distanceTo({normal, 0}, at);
  const Obstacle::HalfPlane half{normal, -static_cast<std::int64_t>(divideRounded(along, int128{PrecisePoint::kOne}))};
  leg.hit->edge = edgeOf(*placementOf(instances, warpHit).shape, segmentOf(instances, warpHit), half);
}

// Whether the leg leads away from the warp segment or along it. It then does not need the instance behind the warp.
bool movesAwayFromWarp(const StepState& step, const Leg& leg, const LegHit& warpHit) {
  const Placement& placement = placementOf(step.instances, warpHit);
  const Segment& segment = segmentOf(step.instances, warpHit);
  return dot(perpendicular(segment.b - segment.a), placement.at(leg.target) - placement.position) >= 0;
}

void insertFor(StepState& step, Leg& leg, const LegHit& warpHit) {
  const auto warp =
      static_cast<std::uint16_t>(placementOf(step.instances, warpHit).part->warpOfSegment(warpHit.segment));
  if (step.instances.isAtInstanceLimit(warpHit.placement)) {
    stopAtWarp(step, leg, warpHit, Leg::End::kFull);
  } else if (step.insertBehind(warpHit.placement, warp)) {
    if (clampToRange(step, leg)) {  // the new instance reaches the coordinate limit earlier
      findHit(step, leg);
    } else {
      findHit(step, leg, step.instances.all().size() - 1);
    }
  } else if (movesAwayFromWarp(step, leg, warpHit)) {
    step.buffers.refusedWarps.push_back({warpHit.placement, warp});
    leg.lacksInstance = true;
  } else {
    stopAtWarp(step, leg, warpHit, Leg::End::kRefused);
  }
}

void insertInstances(StepState& step, Leg& leg) {
  step.buffers.refusedWarps.clear();
  if (!step.collider.isNearWarps(step.instances)) return;
  const std::size_t before = step.instances.all().size();
  while (leg.end == Leg::End::kReached || leg.end == Leg::End::kStopped) {
    const Collider::Path path{step.position(), leg.target, Tolerances::kInsert};
    const auto warpHit = step.collider.firstWarp(step.instances, path, leg.hit, step.buffers.refusedWarps);
    if (!warpHit) break;
    insertFor(step, leg, *warpHit);
  }
  if (step.instances.all().size() != before) step.observe();
}

}  // namespace

Leg findLeg(StepState& step, const LegPlan& plan) {
  Leg leg{plan};
  clampToRange(step, leg);
  findHit(step, leg);
  insertInstances(step, leg);
  return leg;
}

std::optional<Leg> findSlide(StepState& step, const LegPlan& plan) {
  assert(plan.slides);
  std::optional<Leg> leg(Leg{plan});
  if (clampToRange(step, *leg)) return std::nullopt;
  findHit(step, *leg);
  if (step.collider.entersEarlier(step.instances, step.contact->segment, step.place, step.remaining))
    return std::nullopt;
  insertInstances(step, *leg);
  return leg;
}

namespace {

// The home place `at`, moved so that the ideal place of the instance that hit the edge is not inside of it.
PrecisePoint onto(const Instances& instances, const LegHit& hit, PrecisePoint at) {
  if (hit.placement == 0) return putOnto(hit.edge.half, at);
  const PrecisePoint there = instances.idealOf(hit.placement, at);
  return at + toHome(instances, hit, putOnto(hit.edge.half, there) - there);
}

}  // namespace

PrecisePoint placeAfter(const StepState& step, const Leg& leg) {
  PrecisePoint end = step.place + (leg.hit ? scaled(leg.displacement, leg.hit->hit.time) : leg.displacement);
  if (leg.plan.slides) end = onto(step.instances, *step.contact, end);
  return leg.hit ? onto(step.instances, *leg.hit, end) : end;
}

PrecisePoint remainingAfter(const StepState& step, const Leg& leg) {
  const Fraction time = leg.hit ? leg.hit->hit.time : Fraction{1, 1};
  return step.remaining - scaled(scaled(scaled(step.remaining, leg.plan.share), leg.share), time);
}

void turnCorner(const StepState& step, LegHit& hit, PrecisePoint end) {
  const PrecisePoint there = step.instances.idealOf(hit.placement, end);
  const PrecisePoint onwards = fromHome(step.instances, hit, step.remaining);
  if (roomOn(hit.edge, there, onwards).isEnough()) return;
  const EdgeSlide along = slideAlong(hit.edge, there, onwards);
  if (maxNorm(along.displacement) > Tolerances::kNoProgress) return;
  const Convex& shape = *placementOf(step.instances, hit).shape;
  const Segment& segment = segmentOf(step.instances, hit);
  const std::size_t index = adjacent(shape, segment, hit.edge.half.normal, along.back);
  const Obstacle::HalfPlane next = halfPlaneOf(shape, segment, index);
  if (distanceTo({next.normal, 0}, onwards) >= 0) return;  // leads past the corner
  hit.hit = Sweep::hitOf(shape, segment, {.enter = hit.hit.time, .entered = index});
  hit.edge = edgeOf(shape, segment, next);
}

bool isOnContact(const StepState& step, const LegHit& hit) {
  return hit.placement == step.contact->placement && hit.segment == step.contact->segment &&
         hit.edge.half.normal == step.contact->edge.half.normal;
}

namespace {

// Whether a displacement of the place at once enters the obstacle of the contact.
bool leadsIntoContact(const StepState& step, PrecisePoint displacement) {
  const Instances& instances = step.instances;
  const LegHit& contact = *step.contact;
  const auto entered =
      clipIdeal(*placementOf(instances, contact).shape, segmentOf(instances, contact),
                instances.idealOf(contact.placement, step.place), fromHome(instances, contact, displacement));
  return entered && maxNorm(scaled(displacement, entered->time)) <= Tolerances::kNoProgress;
}

}  // namespace

bool isCaughtAt(const StepState& step, const LegHit& hit) {
  if (restsOn(step, hit)) return leadsIntoContact(step, PrecisePoint());
  const PrecisePoint along = alongEdge(hit.edge.half.normal, fromHome(step.instances, hit, step.remaining));
  return leadsIntoContact(step, toHome(step.instances, hit, along));
}

}  // namespace platon
