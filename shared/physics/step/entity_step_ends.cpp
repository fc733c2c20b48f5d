// Passing segment ends that protrude slightly (I3).
#include <algorithm>
#include <cstdlib>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/turned_normal.h"

namespace platon {
namespace {

// Offsets of a nudge, nearest first. The first one is (0, 0) and is not used.
constexpr auto kNudgeOffsets = latticeDisc<EntityStep::kNudge>();

int128 squared(PrecisePoint vector) {
  return int128{vector.x >> 8} * (vector.x >> 8) + int128{vector.y >> 8} * (vector.y >> 8);
}

// Whether the shape is too small for nudges: it could be nudged back and forth between the two sides of an end.
bool isTiny(const Convex& shape) {
  const Point size = shape.bounds().high - shape.bounds().low;
  return std::max(size.x, size.y) < 8 * EntityStep::kNudge;
}

}  // namespace

// Whether an end stops the ideal place, or leaves it less than 1/32 of its speed. Otherwise it slides along the end, as
// it does if the end is past in 1/32 of the remaining time.
bool EntityStep::isBlockedByEnd(const LegHit& hit, PrecisePoint place, PrecisePoint rest) const {
  if (hit.hit.side != Hit::Side::kSegmentEnd) return false;
  const int128 before = contact_ ? squaredSlide(*contact_) : squared(rest_);
  if (1024 * squaredSlide(hit) >= before) return false;
  const IdealSlide slide = slideFrom(hit, place, rest);
  return !slide.cut || slide.share > Fraction{1, 32};
}

// Of the remaining displacement along the edge of `hit`, in 2^-32 of the units of PrecisePoint.
int128 EntityStep::squaredSlide(const LegHit& hit) const { return squared(alongEdge(homeNormalOf(hit), rest_)); }

// Whether the body touches an end of the segment, perhaps with a vertex.
bool EntityStep::touchesEnd(LegHit& hit, PrecisePoint place) const {
  if (hit.hit.side == Hit::Side::kSegmentEnd) return true;
  const Segment& segment = instances_.all()[hit.placement].part->segments[hit.segment];
  const ObstacleEdge& edge = hit.edge;
  const Point tangent = perpendicular(edge.half.normal);
  const PrecisePoint there = instances_.idealOf(hit.placement, place);
  const int128 near = int128{Tolerances::kNoProgress} * (std::abs(tangent.x) + std::abs(tangent.y));
  const bool isHigh = distanceTo({tangent, -edge.high}, there) >= -near;
  if (!isHigh && distanceTo({tangent, -edge.low}, there) > near) return false;
  hit.hit.side = Hit::Side::kSegmentEnd;
  hit.hit.feature = (dot(tangent, segment.b - segment.a) > 0) == isHigh ? segment.b : segment.a;
  return true;
}

// I3: passes a segment end that protrudes slightly from an edge with this normal, on which the ideal place is at `from`
// and slides. Where the normal is that of the end itself, it goes straight on.
bool EntityStep::passEnd(LegHit end, Point normal, PrecisePoint from, PrecisePoint rest) {
  if (!touchesEnd(end, from)) return false;
  const bool straight = normal == homeNormalOf(end);
  const PrecisePoint onwards = straight ? rest : alongEdge(normal, rest);
  const Point reached = roundedAt(from);
  const Point target = reached + rounded(onwards);
  if (target == reached || !allInRange(target)) return false;
  const auto nudged = nudge(end, target, reached);
  if (!nudged) return false;
  moveTo(*nudged);
  ideal_ = precise(*nudged);
  rest_ = rest;
  contact_.reset();
  planAfterNudge_ = LegPlan{precise(target - reached)};  // on the path that is free
  return true;
}

// I3: the position, at most kNudge subunits beside `reached`, from which the segment end is passed. The path must
// continue from there, so that an entity at rest is not nudged back and forth, and must lead past the end.
std::optional<Point> EntityStep::nudge(const LegHit& hit, Point target, Point reached) {
  const Placement& placement = instances_.all()[hit.placement];
  if (isTiny(*placement.shape) || !grazes(hit, target, reached) || !isAtJoint(hit)) return std::nullopt;
  for (const Point offset : std::span(kNudgeOffsets).subspan(1)) {
    const Point from = reached + offset;
    const Point to = target + offset;
    const bool leadsPast = distanceTo({to - position(), 0}, tick_) > 0 && dot(to - position(), homeNormalOf(hit)) < 0;
    if (!leadsPast || !allInRange(to)) continue;
    if (continuesPast(hit, from, to) && collider_.isFree(instances_, position(), from)) return from;
  }
  return std::nullopt;
}

// Whether another segment, perhaps on a neighbouring face, reaches the end. An end that stands alone stops the body, as
// it stops the ideal one.
bool EntityStep::isAtJoint(const LegHit& hit) {
  const std::vector<Placement>& placements = instances_.all();
  const Placement& own = placements[hit.placement];
  if (collider_.hasSegmentNear(own, hit.hit.feature, Tolerances::kJoint, hit.segment)) return true;
  const Point end = rotate(hit.hit.feature - own.position, own.toHome);  // from the position of the body
  return std::any_of(placements.begin(), placements.end(), [&](const Placement& other) {
    return &other != &own && collider_.hasSegmentNear(other, other.position + rotate(end, other.fromHome),
                                                      Tolerances::kJointAcross, Collider::kNoSegment);
  });
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
  if (next->placement != end.placement || next->segment != end.segment) return !isImmediate(next->hit, to - from);
  const Point tangent = perpendicular(homeNormalOf(*next));
  const Point direction = distanceTo({tangent, 0}, tick_) >= 0 ? tangent : -tangent;
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
