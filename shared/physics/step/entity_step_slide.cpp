// Slides along the edge that stopped a leg.
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/step/entity_step.h"

namespace platon {

EntityStep::LegPlan EntityStep::planLeg() {
  if (planAfterNudge_) return *std::exchange(planAfterNudge_, std::nullopt);
  const LegPlan free{rest_, rest_};
  if (!contact_) return free;
  const Placement& placement = instances_.all()[contact_->placement];
  if (distanceTo({contact_->edge.normal, 0}, rotated(rest_, placement.fromHome)) < 0) {
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
  const Placement& placement = instances_.all()[hit.placement];
  const ObstacleEdge edge = edgeOf(*placement.shape, placement.part->segments[hit.segment], hit.edge);
  return slideOn(edge, instances_.idealOf(hit.placement, place), rotated(rest, placement.fromHome));
}

EntityStep::LegPlan EntityStep::planSlide(const LegHit& hit) const {
  const IdealSlide slide = slideFrom(hit, ideal_, rest_);
  const Placement& placement = instances_.all()[hit.placement];
  if (maxNorm(slide.uncut) < Tolerances::kRest && restsOn(hit.edge.normal, placement)) return {{}, {}, {1, 1}, true};
  return {rotated(slide.displacement, placement.toHome), rotated(slide.uncut, placement.toHome), slide.share, true,
          slide.cut};
}

// At the end of the edge, in the direction of the slide, the next edge of the obstacle blocks.
void EntityStep::turnCorner(LegHit& hit, PrecisePoint place) const {
  const Placement& placement = instances_.all()[hit.placement];
  const Segment& segment = placement.part->segments[hit.segment];
  const IdealSlide slide = slideFrom(hit, place, rest_);
  if (!slide.cut || maxNorm(slide.displacement) > Tolerances::kNoProgress) return;
  const std::size_t index = adjacent(*placement.shape, segment, hit.edge.normal, slide.back);
  const Obstacle::HalfPlane next = halfPlaneOf(*placement.shape, segment, index);
  if (distanceTo({next.normal, 0}, rotated(rest_, placement.fromHome)) >= 0) return;  // leads past the corner
  hit.hit = Sweep::hitOf(*placement.shape, segment, {hit.hit.time, hit.hit.exit, index, false});
  hit.edge = next;
}

// Whether the slide of a whole tick along an edge with this normal is too short to be one.
bool EntityStep::restsOn(Point normal, const Placement& placement) const {
  return maxNorm(alongEdge(normal, rotated(tick_, placement.fromHome))) < Tolerances::kRest;
}

// Whether the body is caught between the present contact and `hit`: the slide along each leads into the other.
bool EntityStep::isWedged(const LegHit& hit) {
  if (isSameEdge(hit, *contact_) || ++idleLegs_ > kMaxIdleLegs) return true;
  if (distanceTo({homeNormalOf(hit), 0}, tick_) >= 0) return true;  // only the slide leads into it
  return leadsInto(planSlide(hit).uncut, *contact_);
}

// Whether a displacement of the ideal place at once enters the obstacle of the contact.
bool EntityStep::leadsInto(PrecisePoint displacement, const LegHit& contact) const {
  const Placement& placement = instances_.all()[contact.placement];
  const auto interval =
      clipIdeal(*placement.shape, placement.part->segments[contact.segment],
                instances_.idealOf(contact.placement, ideal_), rotated(displacement, placement.fromHome));
  return interval && maxNorm(scaled(displacement, interval->enter)) <= Tolerances::kNoProgress;
}

bool EntityStep::isSameEdge(const LegHit& a, const LegHit& b) {
  return a.placement == b.placement && a.segment == b.segment && a.edge.normal == b.edge.normal;
}

}  // namespace platon
