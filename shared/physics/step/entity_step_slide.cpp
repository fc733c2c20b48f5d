// Slides along the edge that stopped a leg.
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/step/entity_step.h"

namespace platon {

EntityStep::LegPlan EntityStep::planLeg() {
  if (planAfterNudge_) return *std::exchange(planAfterNudge_, std::nullopt);
  const LegPlan free{rest_};
  if (!contact_) return free;
  if (distanceTo({contact_->edge.half.normal, 0}, fromHome(*contact_, rest_)) < 0) {
    const LegPlan plan = planSlide(*contact_);
    if (plan.displacement == PrecisePoint() && passEnd(*contact_, homeNormalOf(*contact_), ideal_, rest_))
      return *std::exchange(planAfterNudge_, std::nullopt);
    return plan;
  }
  contact_.reset();
  return free;
}

// The slide of the home place `place` along the edge that was hit, in the frame of its part.
IdealSlide EntityStep::slideFrom(const LegHit& hit, PrecisePoint place, PrecisePoint rest) const {
  return slideOn(hit.edge, instances_.idealOf(hit.placement, place), fromHome(hit, rest));
}

EntityStep::LegPlan EntityStep::planSlide(const LegHit& hit) const {
  const IdealSlide slide = slideFrom(hit, ideal_, rest_);
  if (maxNorm(slide.displacement) < Tolerances::kRest && restsOn(hit)) return {{}, {1, 1}, true};
  return {toHome(hit, slide.displacement), slide.share, true, slide.cut};
}

// The slide along the edge that was hit if that were infinite, in the frame of the home part.
PrecisePoint EntityStep::slideWithoutEnd(const LegHit& hit) const {
  return toHome(hit, alongEdge(hit.edge.half.normal, fromHome(hit, rest_)));
}

// At the end of the edge, in the direction of the slide, the next edge of the obstacle blocks.
void EntityStep::turnCorner(LegHit& hit, PrecisePoint place) const {
  const PrecisePoint there = instances_.idealOf(hit.placement, place);
  const PrecisePoint onwards = fromHome(hit, rest_);
  if (roomOn(hit.edge, there, onwards).isEnough()) return;
  const IdealSlide slide = slideOn(hit.edge, there, onwards);
  if (maxNorm(slide.displacement) > Tolerances::kNoProgress) return;
  const Placement& placement = instances_.all()[hit.placement];
  const Segment& segment = placement.part->segments[hit.segment];
  const std::size_t index = adjacent(*placement.shape, segment, hit.edge.half.normal, slide.back);
  const Obstacle::HalfPlane next = halfPlaneOf(*placement.shape, segment, index);
  if (distanceTo({next.normal, 0}, onwards) >= 0) return;  // leads past the corner
  hit.hit = Sweep::hitOf(*placement.shape, segment, {hit.hit.time, hit.hit.exit, index, false});
  hit.edge = edgeOf(*placement.shape, segment, next);
}

// Whether the slides of the remaining displacement and of the whole tick along the edge are too short to be slides.
bool EntityStep::restsOn(const LegHit& hit) const {
  const Point normal = hit.edge.half.normal;
  return maxNorm(alongEdge(normal, fromHome(hit, rest_))) < Tolerances::kRest &&
         maxNorm(alongEdge(normal, fromHome(hit, tick_))) < Tolerances::kRest;
}

// Whether the body is caught between the present contact and `hit`: the slide along each leads into the other.
bool EntityStep::isWedged(const LegHit& hit) {
  if (isSameEdge(hit, *contact_) || ++idleLegs_ > kMaxIdleLegs) return true;
  return leadsInto(restsOn(hit) ? PrecisePoint() : slideWithoutEnd(hit), *contact_);
}

// Whether a displacement of the ideal place at once enters the obstacle of the contact.
bool EntityStep::leadsInto(PrecisePoint displacement, const LegHit& contact) const {
  const Placement& placement = instances_.all()[contact.placement];
  const auto interval = clipIdeal(*placement.shape, placement.part->segments[contact.segment],
                                  instances_.idealOf(contact.placement, ideal_), fromHome(contact, displacement));
  return interval && maxNorm(scaled(displacement, interval->enter)) <= Tolerances::kNoProgress;
}

bool EntityStep::isSameEdge(const LegHit& a, const LegHit& b) {
  return a.placement == b.placement && a.segment == b.segment && a.edge.half.normal == b.edge.half.normal;
}

}  // namespace platon
