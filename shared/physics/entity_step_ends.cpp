// Passing segment ends that protrude slightly (I3).
#include <algorithm>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/entity_step.h"
#include "shared/physics/slide.h"

namespace platon {
namespace {

// Offsets of a nudge, nearest first. The first one is (0, 0) and is not used.
constexpr auto kNudgeOffsets = latticeDisc<EntityStep::kNudge>();

// Whether the shape is too small for nudges: it could be nudged back and forth between the two sides of an end.
bool isTiny(const Convex& shape) {
  const Point size = shape.bounds().high - shape.bounds().low;
  return std::max(size.x, size.y) < 8 * EntityStep::kNudge;
}

}  // namespace

bool EntityStep::tryPassEnd(const Leg& leg, const LegPlan& plan, Point reached) {
  if (leg.hit->hit.side != Hit::Side::kSegmentEnd) return false;
  const Point moved = reached - position();
  const Point onwards = plan.slides ? plan.uncut - moved : leg.target - reached;
  if (nudgePast(*leg.hit, {onwards, onwards, plan.slides}, reached, remainingAfter(plan, moved))) return true;
  const auto ground = groundBehind(*leg.hit, leg.target, reached);
  return ground && passEndAlong(*leg.hit, *ground, plan, reached);
}

// The hit that follows within kContactGap when the segment whose end was hit is ignored.
std::optional<LegHit> EntityStep::groundBehind(const LegHit& end, Point target, Point reached) {
  const Point displacement = target - position();
  const Point beyond = reached + displacement;
  if (!allInRange(beyond)) return std::nullopt;
  const auto ground = collider_.first(instances_, reached, beyond, &end);
  if (!ground || ground->hit.side == Hit::Side::kInside) return std::nullopt;
  return exceedsContactGap(homeNormalOf(*ground), scaleTruncated(displacement, ground->hit.time)) ? std::nullopt
                                                                                                  : ground;
}

// Passes a segment end that protrudes from another segment (the ground), on which the entity slides. The direction is
// that of the ground, because the remaining displacement may point more steeply towards it.
bool EntityStep::passEndAlong(const LegHit& end, const LegHit& ground, const LegPlan& plan, Point reached) {
  if (end.hit.side != Hit::Side::kSegmentEnd) return false;
  const Point remaining = remainingAfter(plan, reached - position());
  const Point along = slideAlong(remaining, homeNormalOf(ground));
  if (along == Point() || dot(along, homeNormalOf(end)) >= 0 || !allInRange(reached + along)) return false;
  if (!nudgePast(end, {along, along, true}, reached, remaining)) return false;
  callContact(ground);
  return true;
}

// I3: continues beside a segment end if a nudge clears it. `onwards` becomes the plan of the next leg and `remaining`
// the remaining displacement.
bool EntityStep::nudgePast(const LegHit& end, const LegPlan& onwards, Point reached, Point remaining) {
  if (onwards.displacement == Point() || isSameSegment(end, lastSlide_)) return false;
  const auto nudged = nudge(end, reached + onwards.displacement, reached);
  if (!nudged) return false;
  const Point start = position();
  unobstructed_ = false;
  moveTo(*nudged);
  callPierced(start);
  remaining_ = remaining;
  planAfterNudge_ = onwards;
  return true;
}

// I3: the position, at most kNudge subunits beside `reached`, from which the segment end is passed. The path must
// continue from there, so that an entity at rest is not nudged back and forth, and must lead past the end.
std::optional<Point> EntityStep::nudge(const LegHit& hit, Point target, Point reached) {
  const Placement& placement = instances_.all()[hit.placement];
  if (isTiny(*placement.shape) || !grazes(hit, target, reached)) return std::nullopt;
  for (const Point offset : std::span(kNudgeOffsets).subspan(1)) {
    const Point from = reached + offset;
    const Point to = target + offset;
    const bool leadsPast = dot(to - position(), tickDisplacement_) > 0 && dot(to - position(), homeNormalOf(hit)) < 0;
    if (!leadsPast || !allInRange(to)) continue;
    if (continuesPast(hit, from, to) && collider_.isFree(instances_, position(), from)) return from;
  }
  return std::nullopt;
}

// Whether the segment end is within kNudge of a flank of the shape. Otherwise no nudge can clear it.
// Bounds: side < 2^30, differences < 2^31, so that products are < 2^62.
bool EntityStep::grazes(const LegHit& hit, Point target, Point reached) const {
  const Placement& placement = instances_.all()[hit.placement];
  const Point from = placement.at(reached);
  const Point side = perpendicular(placement.at(target) - from);
  const Point feature = hit.hit.feature - from;
  std::int64_t low = dot(side, placement.shape->vertices()[0]);
  std::int64_t high = low;
  for (const Point vertex : placement.shape->vertices()) {
    if (squaredLength(feature - vertex) <= 2 * kNudge * kNudge) return true;
    low = std::min(low, dot(side, vertex));
    high = std::max(high, dot(side, vertex));
  }
  const std::int64_t end = dot(side, feature);
  const int128 depth = std::min(end - low, high - end);
  return depth <= 0 || depth * depth <= int128{kNudge * kNudge} * squaredLength(side);
}

// Whether the path from `from` to `to` passes the end and then either continues for more than a nudge or slides along
// the segment, away from the end.
bool EntityStep::continuesPast(const LegHit& end, Point from, Point to) {
  if (hitsEndAgain(end, from, to)) return false;
  const auto next = collider_.first(instances_, from, to);
  if (!next) return true;
  if (!isSameSegment(*next, end)) return !isImmediate(next->hit, to - from);
  const Point direction = slideDirection(*next);
  return next->hit.side == Hit::Side::kSegment && dot(direction, to - from) > 0 && dot(direction, awayFromEnd(end)) > 0;
}

// Fast path of continuesPast: whether the path immediately hits the same end again, which is usual.
bool EntityStep::hitsEndAgain(const LegHit& end, Point from, Point to) {
  const Placement& placement = instances_.all()[end.placement];
  const auto again = collider_.hit(placement, {placement.at(from), placement.at(to)}, end.segment);
  return again && again->side != Hit::Side::kSegment && isImmediate(*again, to - from);
}

bool EntityStep::isImmediate(const Hit& hit, Point displacement) {
  return squaredLength(scaleTruncated(displacement, hit.time)) <= squaredLength(Point(kNudge, kNudge));
}

// The vector from the end that was hit to the other end, in the frame of the home part. Coordinates below 2^30.
Point EntityStep::awayFromEnd(const LegHit& end) const {
  const Placement& placement = instances_.all()[end.placement];
  const Segment& segment = placement.part->segments[end.segment];
  const Point along = segment.a == end.hit.feature ? segment.b - segment.a : segment.a - segment.b;
  return rotate(along, placement.toHome);
}

}  // namespace platon
