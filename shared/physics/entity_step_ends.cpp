// How ends of lines that stand out a little are passed (I3).
#include <algorithm>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/entity_step.h"
#include "shared/physics/slide.h"

namespace platon {
namespace {

// Sideways steps; the first of all, no step, is none.
constexpr auto kNudgeOffsets = latticeDisc<EntityStep::kNudge>();

// A nudge would bring a shape hardly larger than itself to the other side of the end, to and fro for ever.
bool isTiny(const Convex& shape) {
  const Point size = shape.bounds().high - shape.bounds().low;
  return std::max(size.x, size.y) < 8 * EntityStep::kNudge;
}

}  // namespace

bool EntityStep::tryToPass(const Leg& leg, const Way& way, Point reached) {
  if (leg.hit->hit.side != Hit::Side::kSegmentEnd) return false;
  const Point moved = reached - position();
  const Point onwards = way.slides ? way.whole - moved : leg.target - reached;
  if (nudgePast(*leg.hit, {onwards, onwards, way.slides}, reached, restAfter(way, moved))) return true;
  const auto ground = groundBehind(*leg.hit, leg.target, reached);
  return ground && passAlong(*leg.hit, *ground, way, reached);
}

// What the entity would meet, close by, if the line whose end it has met were not there.
std::optional<LegHit> EntityStep::groundBehind(const LegHit& end, Point target, Point reached) {
  const Point displacement = target - position();
  const Point beyond = reached + displacement;
  if (!allInRange(beyond)) return std::nullopt;
  const auto ground = collider_.first(instances_, reached, beyond, &end);
  if (!ground || ground->hit.side == Hit::Side::kInside) return std::nullopt;
  return isApart(homeNormalOf(*ground), scaleTruncated(displacement, ground->hit.time)) ? std::nullopt : ground;
}

// The end of a line that stands out a little from another one, which the entity slides along, is passed as that other
// line's own direction tells: what is wanted may lead down to it more steeply.
bool EntityStep::passAlong(const LegHit& end, const LegHit& ground, const Way& way, Point reached) {
  if (end.hit.side != Hit::Side::kSegmentEnd) return false;
  const Point left = restAfter(way, reached - position());
  const Point along = slideAlong(left, homeNormalOf(ground));
  if (along == Point() || dot(along, homeNormalOf(end)) >= 0 || !allInRange(reached + along)) return false;
  if (!nudgePast(end, {along, along, true}, reached, left)) return false;
  callContact(ground);
  return true;
}

// I3: goes on beside the end of a line, where a nudge clears it. `onwards` is where to from there, `left` what will be
// left of the displacement.
bool EntityStep::nudgePast(const LegHit& end, const Way& onwards, Point reached, Point left) {
  if (onwards.part == Point() || isSameLine(end, slidAlong_)) return false;
  const auto nudged = nudge(end, reached + onwards.part, reached);
  if (!nudged) return false;
  const Point start = position();
  isFree_ = false;
  moveTo(*nudged);
  callPierced(start);
  rest_ = left;
  onwards_ = onwards;
  return true;
}

// I3: an end of a line that a step of a few subunits to the side clears is passed, not hit. The way must lead on from
// there, so that nothing at rest is ever nudged to and fro; and past the end, where a slide would lead beside it.
std::optional<Point> EntityStep::nudge(const LegHit& hit, Point target, Point reached) {
  const Placement& placement = instances_.all()[hit.placement];
  if (isTiny(*placement.shape) || !grazes(hit, target, reached)) return std::nullopt;
  for (const Point offset : std::span(kNudgeOffsets).subspan(1)) {
    const Point from = reached + offset;
    const Point to = target + offset;
    const bool leadsPast = dot(to - position(), wanted_) > 0 && dot(to - position(), homeNormalOf(hit)) < 0;
    if (!leadsPast || !allInRange(to)) continue;
    if (leadsOn(hit, from, to) && collider_.isFree(instances_, position(), from)) return from;
  }
  return std::nullopt;
}

// Whether the end of the line passes within kNudge of either flank of the shape: else no nudge can clear it.
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

// Whether the way from `from` to `to` passes the end, and leads either along its line, away from that end, or some way
// on.
bool EntityStep::leadsOn(const LegHit& end, Point from, Point to) {
  if (meetsAtOnce(end, from, to)) return false;
  const auto next = collider_.first(instances_, from, to);
  if (!next) return true;
  if (!isSameLine(*next, end)) return !isAtOnce(next->hit, to - from);
  const Point way = slideDirection(*next);
  return next->hit.side == Hit::Side::kSegment && dot(way, to - from) > 0 && dot(way, fromEnd(end)) > 0;
}

// Whether the way meets the end again, or something else before it, at once. Most often it does, and the other lines
// need not be asked.
bool EntityStep::meetsAtOnce(const LegHit& end, Point from, Point to) {
  const Placement& placement = instances_.all()[end.placement];
  const auto again = collider_.hit(placement, {placement.at(from), placement.at(to)}, end.line);
  return again && again->side != Hit::Side::kSegment && isAtOnce(*again, to - from);
}

bool EntityStep::isAtOnce(const Hit& hit, Point displacement) {
  return squaredLength(scaleTruncated(displacement, hit.time)) <= squaredLength(Point(kNudge, kNudge));
}

// From the end that was met to the other one, in home's frame. Below 2^30.
Point EntityStep::fromEnd(const LegHit& end) const {
  const Placement& placement = instances_.all()[end.placement];
  const Segment& line = placement.part->segments[end.line];
  const Point along = line.a == end.hit.feature ? line.b - line.a : line.a - line.b;
  return rotate(along, placement.toHome);
}

}  // namespace platon
