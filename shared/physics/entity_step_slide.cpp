// Slides along the segment that stopped a leg.
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/entity_step.h"
#include "shared/physics/slide.h"

namespace platon {

EntityStep::LegPlan EntityStep::planLeg() {
  if (planAfterNudge_) return *std::exchange(planAfterNudge_, std::nullopt);
  if (!stop_) return {remaining_, remaining_, false};
  lastSlide_ = stop_;
  const Point normal = homeNormalOf(*stop_);
  const Point uncut = slideAlong(remaining_, normal);
  if (uncut == Point()) return {uncut, uncut, true};
  const bool back = dot(remaining_, perpendicular(normal)) < 0;
  const Point slide =
      segmentExtendsBeyondSlide(*stop_, back) ? uncut : slideAlong(remaining_, normal, slideLimits(*stop_, back));
  return {keepOutside(*stop_, slide), uncut, true};
}

// Fast path of slideLimits: whether the segment certainly extends beyond the whole remaining displacement.
bool EntityStep::segmentExtendsBeyondSlide(const LegHit& stop, bool back) const {
  if (stop.hit.side != Hit::Side::kSegment) return false;
  const Placement& placement = instances_.all()[stop.placement];
  const Point tangent = perpendicular(stop.hit.normal);
  return extendsBeyond(maxNorm(remaining_), placement.shape->bounds(), placement.position,
                       placement.part->segments[stop.segment], back ? -tangent : tangent);
}

// How far the home instance can slide, forward or back, until the obstacle edge that stopped it ends.
SlideLimits EntityStep::slideLimits(const LegHit& stop, bool back) const {
  const Placement& placement = instances_.all()[stop.placement];
  const Segment& segment = placement.part->segments[stop.segment];
  const Point toEnd = displacementToEdgeEnd(*placement.shape, placement.position, segment, normalOf(stop), back);
  SlideLimits limits;
  (back ? limits.backward : limits.forward) = maxNorm(rotate(toEnd, placement.toHome));
  return limits;
}

// The instance that hit the segment rounds the displacement in its own frame, which could move it into the segment.
// Adds up to kNudge subunits outwards to prevent that. Bounds: normal < 2^30, displacement < 2^31.
Point EntityStep::keepOutside(const LegHit& stop, Point slide) const {
  const Placement& placement = instances_.all()[stop.placement];
  const Point outwards = dominantStep(homeNormalOf(stop));
  for (int steps = 0; steps < kNudge && slide != Point(); ++steps, slide += outwards) {
    if (dot(normalOf(stop), placement.at(position() + slide) - placement.position) >= 0) break;
  }
  return slide;
}

// The direction of a slide along the segment of `hit`: that of the tangential component of the tick's displacement. Not
// normalised; (0, 0) when there is no such component.
Point EntityStep::slideDirection(const LegHit& hit) const {
  const Point tangent = perpendicular(homeNormalOf(hit));
  const std::int64_t along = dot(tickDisplacement_, tangent);
  return along == 0 ? Point() : along > 0 ? tangent : -tangent;
}

// Whether a slide along the segment of `hit` would lead back into the current stop, or has been tried at this position.
bool EntityStep::leadsBack(const LegHit& hit) const {
  const Point direction = slideDirection(hit);
  const bool intoStop = dot(direction, homeNormalOf(*stop_)) < 0 && dot(direction, slideDirection(*stop_)) <= 0;
  return intoStop || isSameSegment(hit, stop_) || isSameSegment(hit, previousStop_);
}

// Whether the slide is caught in a wedge: it gains nothing in the direction of the tick's displacement up to `end`,
// where the segment of `next` would lead it back. Every other move gains something, so no sequence of moves returns a
// resting entity to a previous position (I4).
bool EntityStep::isWedge(const LegHit& next, Point end) const {
  return dot(end - position(), tickDisplacement_) <= 0 && leadsBack(next);
}

// Whether a displacement moves farther than kContactGap along `normal`. Bounds: normal < 2^30, displacement < 2^31.
bool EntityStep::exceedsContactGap(Point normal, Point displacement) {
  const int128 depth = dot(normal, displacement);
  return depth * depth > int128{kContactGap * kContactGap} * squaredLength(normal);
}

// Near a wedge, some lattice points are slightly above both segments, and the two segments would send the entity back
// and forth. A slide that gains nothing is therefore shortened until it ends before its reversal.
Point EntityStep::stopBeforeReversal(Point target) {
  Point slide = target - position();
  while (slide != Point()) {
    const Point end = position() + slide;
    const bool isFree = end == target || collider_.isFree(instances_, position(), end);
    if (isFree && (dot(slide, tickDisplacement_) > 0 || !isReversedAt(end))) return end;
    slide = slideAlong({slide.x / 2, slide.y / 2}, homeNormalOf(*stop_));
  }
  return position();
}

bool EntityStep::isReversedAt(Point end) {
  const Point target = end + tickDisplacement_;
  if (!allInRange(target)) return false;
  const auto next = collider_.first(instances_, end, target, &*stop_);
  return next && leadsBack(*next) &&
         !exceedsContactGap(homeNormalOf(*next), scaleTruncated(tickDisplacement_, next->hit.time));
}

// Discards the remaining displacement in a wedge, unless one of the two is a segment end that can be passed.
void EntityStep::stopInWedge(const LegHit& next, const LegPlan& plan) {
  const LegHit stop = *stop_;
  if (passEndAlong(stop, next, plan, position())) return;
  unobstructed_ = false;
  callContact(next);
  remaining_ = Point();
}

bool EntityStep::isSameSegment(const LegHit& a, const std::optional<LegHit>& b) {
  return b && a.placement == b->placement && a.segment == b->segment;
}

}  // namespace platon
