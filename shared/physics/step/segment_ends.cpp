#include <algorithm>
#include <cstdlib>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/tolerances.h"

namespace platon {
namespace {

constexpr std::int32_t kNudge = Tolerances::kNudge;

// Offsets of a nudge, nearest first. The first one is (0, 0) and is not used.
constexpr auto kNudgeOffsets = latticeDisc<kNudge>();

// In squares of 2^-18 subunits.
int128 squared(PrecisePoint vector) {
  return int128{vector.x >> 8} * (vector.x >> 8) + int128{vector.y >> 8} * (vector.y >> 8);
}

// The squared length of the remaining displacement along the edge of `hit`.
int128 squaredSlide(const StepState& step, const LegHit& hit) {
  return squared(alongEdge(homeNormalOf(step.instances, hit), step.remaining));
}

// Whether the shape is too small for nudges: it could be nudged back and forth between the two sides of an end.
bool isTiny(const Convex& shape) {
  const Point size = shape.bounds().high - shape.bounds().low;
  return std::max(size.x, size.y) < 8 * kNudge;
}

bool isImmediate(const Hit& hit, Point displacement) {
  return squaredLength(scaleTruncated(displacement, hit.time)) <= squaredLength(Point(kNudge, kNudge));
}

// Whether the body at the ideal place `at` touches an end of the segment, perhaps with a vertex. If so, the hit becomes
// one of that end, as `nudged` requires.
bool touchesEnd(const StepState& step, LegHit& end, PrecisePoint at) {
  if (end.hit.side == Hit::Side::kSegmentEnd) return true;
  const Segment& segment = segmentOf(step.instances, end);
  const ObstacleEdge& edge = end.edge;
  const Point tangent = perpendicular(edge.half.normal);
  const PrecisePoint there = step.instances.idealOf(end.placement, at);
  const int128 near = int128{Tolerances::kNoProgress} * (std::abs(tangent.x) + std::abs(tangent.y));
  const bool isHigh = distanceTo({tangent, -edge.high}, there) >= -near;
  if (!isHigh && distanceTo({tangent, -edge.low}, there) > near) return false;
  end.hit.side = Hit::Side::kSegmentEnd;
  end.hit.feature = (dot(tangent, segment.b - segment.a) > 0) == isHigh ? segment.b : segment.a;
  return true;
}

// Whether another segment, perhaps on a neighbouring face, reaches the end. An end that stands alone stops the body, as
// it stops the ideal one.
bool isAtJoint(StepState& step, const LegHit& end) {
  const Placement& own = placementOf(step.instances, end);
  if (step.collider.hasSegmentNear(own, end.hit.feature, Tolerances::kJoint, end.segment)) return true;
  const Point feature = rotate(end.hit.feature - own.position, own.toHome);  // from the position of the body
  return std::any_of(step.instances.all().begin(), step.instances.all().end(), [&](const Placement& other) {
    return &other != &own && step.collider.hasSegmentNear(other, other.position + rotate(feature, other.fromHome),
                                                          Tolerances::kJointAcross, Collider::kNoSegment);
  });
}

// Whether the segment end is within kNudge of a flank of the shape. Otherwise no nudge can clear it.
// Bounds: side < 2^30, differences < 2^31, so that products are < 2^62.
bool grazes(const StepState& step, const LegHit& end, Point reached, Point target) {
  const Placement& placement = placementOf(step.instances, end);
  const Point from = placement.at(reached);
  const Point side = perpendicular(placement.at(target) - from);
  const Point feature = end.hit.feature - from;
  std::int64_t low = dot(side, placement.shape->vertices()[0]);
  std::int64_t high = low;
  for (const Point vertex : placement.shape->vertices()) {
    if (squaredLength(feature - vertex) <= 2 * kNudge * kNudge) return true;
    low = std::min(low, dot(side, vertex));
    high = std::max(high, dot(side, vertex));
  }
  const std::int64_t beside = dot(side, feature);
  const int128 depth = std::min(beside - low, high - beside);
  return depth <= 0 || depth * depth <= int128{kNudge * kNudge} * squaredLength(side);
}

// Whether the tick leads from the ideal place to this one rather than back.
bool isAhead(const StepState& step, PrecisePoint at, Point place) {
  const PrecisePoint gained = precise(place) - at;
  return int128{gained.x} * step.tick.x + int128{gained.y} * step.tick.y > 0;
}

// Fast path of continuesPast: whether the path immediately hits the same end again, which is usual.
bool hitsEndAgain(StepState& step, const LegHit& end, Point from, Point to) {
  const Placement& placement = placementOf(step.instances, end);
  const auto again = step.collider.hit(placement, {placement.at(from), placement.at(to)}, end.segment);
  return again && again->side != Hit::Side::kSegment && isImmediate(*again, to - from);
}

// The vector from the end that was hit to the other end, in the frame of the home part. Coordinates below 2^30.
Point awayFromEnd(const StepState& step, const LegHit& end) {
  const Segment& segment = segmentOf(step.instances, end);
  const Point along = segment.a == end.hit.feature ? segment.b - segment.a : segment.a - segment.b;
  return rotate(along, placementOf(step.instances, end).toHome);
}

// Whether the path from `from` to `to` passes the end and then either leads ahead, to its end or to the next segment,
// or slides along the segment, away from the end. Legs never lead back, so a body that rests is not nudged for ever.
bool continuesPast(StepState& step, const LegHit& end, PrecisePoint at, Point from, Point to) {
  if (hitsEndAgain(step, end, from, to)) return false;
  const auto next = step.collider.first(step.instances, from, to);
  if (!next) return true;
  if (next->placement != end.placement || next->segment != end.segment)
    return !isImmediate(next->hit, to - from) && isAhead(step, at, from + scaleTruncated(to - from, next->hit.time));
  const Point tangent = perpendicular(homeNormalOf(step.instances, *next));
  const Point direction = distanceTo({tangent, 0}, step.tick) >= 0 ? tangent : -tangent;
  return next->hit.side == Hit::Side::kSegment && dot(direction, to - from) > 0 &&
         dot(direction, awayFromEnd(step, end)) > 0;
}

// The position, at most kNudge subunits beside `reached`, from which the segment end is passed. The path must continue
// from there, so that an entity at rest is not nudged back and forth, and must lead past the end.
std::optional<Point> nudged(StepState& step, const LegHit& end, PrecisePoint at, Point reached, Point target) {
  if (isTiny(*placementOf(step.instances, end).shape) || !grazes(step, end, reached, target) || !isAtJoint(step, end))
    return std::nullopt;
  const Point position = step.position();
  for (const Point offset : std::span(kNudgeOffsets).subspan(1)) {
    const Point from = reached + offset;
    const Point to = target + offset;
    if (!step.allInRange(from) || !step.allInRange(to)) continue;
    if (!isAhead(step, at, to) || dot(to - position, homeNormalOf(step.instances, end)) >= 0) continue;
    if (continuesPast(step, end, at, from, to) && step.isFree(position, from) && step.mayBeAt(from)) return from;
  }
  return std::nullopt;
}

}  // namespace

bool isBlockedByEnd(const StepState& step, const LegHit& hit, PrecisePoint at, PrecisePoint remaining) {
  if (hit.hit.side != Hit::Side::kSegmentEnd) return false;
  const int128 before = step.contact ? squaredSlide(step, *step.contact) : squared(step.remaining);
  if (1024 * squaredSlide(step, hit) >= before) return false;
  const EdgeSlide along = slideFrom(step, hit, at, remaining);
  return !along.cut || along.share > Fraction{1, 32};
}

std::optional<Nudge> findNudge(StepState& step, const LegHit& hit, Point normal, PrecisePoint at,
                               PrecisePoint remaining) {
  LegHit end = hit;
  if (!touchesEnd(step, end, at)) return std::nullopt;
  const bool straight = normal == homeNormalOf(step.instances, end);
  const PrecisePoint onwards = straight ? remaining : alongEdge(normal, remaining);
  const Point reached = step.roundedAt(at);
  const Point target = reached + rounded(onwards);
  if (target == reached || !step.allInRange(target)) return std::nullopt;
  const auto to = nudged(step, end, at, reached, target);
  return to ? std::optional(Nudge{*to, target - reached}) : std::nullopt;
}

}  // namespace platon
