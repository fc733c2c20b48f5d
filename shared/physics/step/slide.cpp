#include "shared/physics/step/slide.h"

#include "shared/physics/step/hit_frame.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

// The home place `place`, moved so that the ideal place of the instance that hit the edge is not inside of it.
PrecisePoint onto(const Instances& instances, const LegHit& hit, PrecisePoint place) {
  if (hit.placement == 0) return putOnto(hit.edge.half, place);
  const PrecisePoint there = instances.idealOf(hit.placement, place);
  return place + toHome(instances, hit, putOnto(hit.edge.half, there) - there);
}

}  // namespace

// Where the place is already at the end of the edge, the path leads past the corner.
LegPlan Slide::next() const {
  if (passing) return *passing;
  if (contact && distanceTo({contact->edge.half.normal, 0}, fromHome(instances, *contact, remaining)) < 0) {
    const LegPlan plan = slideAlongContact();
    if (!plan.cut || plan.displacement != PrecisePoint()) return plan;
  }
  return {remaining};
}

LegPlan Slide::slideAlongContact() const {
  const EdgeSlide along = slideFrom(*contact, place, remaining);
  if (maxNorm(along.displacement) < Tolerances::kRest && restsOn(*contact)) return {{}, {1, 1}, true};
  return {toHome(instances, *contact, along.displacement), along.share, true, along.cut};
}

// Whether the slides of the remaining displacement and of the whole tick along the edge are too short to be slides.
bool Slide::restsOn(const LegHit& hit) const {
  const Point normal = hit.edge.half.normal;
  return maxNorm(alongEdge(normal, fromHome(instances, hit, remaining))) < Tolerances::kRest &&
         maxNorm(alongEdge(normal, fromHome(instances, hit, tick))) < Tolerances::kRest;
}

PrecisePoint Slide::endOf(const Leg& leg, const LegPlan& plan) const {
  PrecisePoint end = place + (leg.hit ? scaled(leg.displacement, leg.hit->hit.time) : leg.displacement);
  if (plan.slides) end = onto(instances, *contact, end);
  return leg.hit ? onto(instances, *leg.hit, end) : end;
}

PrecisePoint Slide::remainingAfter(const Leg& leg, const LegPlan& plan) const {
  const Fraction time = leg.hit ? leg.hit->hit.time : Fraction{1, 1};
  return remaining - scaled(scaled(scaled(remaining, plan.share), leg.share), time);
}

void Slide::turnCorner(LegHit& hit, PrecisePoint end) const {
  const PrecisePoint there = instances.idealOf(hit.placement, end);
  const PrecisePoint onwards = fromHome(instances, hit, remaining);
  if (roomOn(hit.edge, there, onwards).isEnough()) return;
  const EdgeSlide along = slideOn(hit.edge, there, onwards);
  if (maxNorm(along.displacement) > Tolerances::kNoProgress) return;
  const Convex& shape = *placementOf(instances, hit).shape;
  const Segment& segment = segmentOf(instances, hit);
  const std::size_t index = adjacent(shape, segment, hit.edge.half.normal, along.back);
  const Obstacle::HalfPlane next = halfPlaneOf(shape, segment, index);
  if (distanceTo({next.normal, 0}, onwards) >= 0) return;  // leads past the corner
  hit.hit = Sweep::hitOf(shape, segment, {hit.hit.time, hit.hit.exit, index, false});
  hit.edge = edgeOf(shape, segment, next);
}

bool Slide::isOnContact(const LegHit& hit) const {
  return hit.placement == contact->placement && hit.segment == contact->segment &&
         hit.edge.half.normal == contact->edge.half.normal;
}

bool Slide::isCaughtAt(const LegHit& hit) const {
  if (restsOn(hit)) return leadsIntoContact(PrecisePoint());
  return leadsIntoContact(toHome(instances, hit, alongEdge(hit.edge.half.normal, fromHome(instances, hit, remaining))));
}

// Whether a displacement of the place at once enters the obstacle of the contact.
bool Slide::leadsIntoContact(PrecisePoint displacement) const {
  const auto entered =
      clipIdeal(*placementOf(instances, *contact).shape, segmentOf(instances, *contact),
                instances.idealOf(contact->placement, place), fromHome(instances, *contact, displacement));
  return entered && maxNorm(scaled(displacement, entered->time)) <= Tolerances::kNoProgress;
}

void Slide::rotateFrame(Angle turn) {
  const Rotation rotation = rotationOf(turn);
  remaining = rotated(remaining, rotation);
  tick = rotated(tick, rotation);
  if (passing) passing->displacement = rotated(passing->displacement, rotation);
  contact.reset();
}

}  // namespace platon
