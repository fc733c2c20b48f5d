// What is left of a displacement slides along what stopped it.
#include <utility>

#include "platon/exact/integer.h"
#include "shared/physics/entity_step.h"
#include "shared/physics/slide.h"

namespace platon {

EntityStep::Way EntityStep::nextWay() {
  if (onwards_) return *std::exchange(onwards_, std::nullopt);
  if (!stop_) return {rest_, rest_, false};
  slidAlong_ = stop_;
  const Point normal = homeNormalOf(*stop_);
  const Point whole = slideAlong(rest_, normal);
  if (whole == Point()) return {whole, whole, true};
  const bool back = dot(rest_, perpendicular(normal)) < 0;
  const Point part = outreaches(*stop_, back) ? whole : slideAlong(rest_, normal, reachOf(*stop_, back));
  return {outOf(*stop_, part), whole, true};
}

// Whether the line plainly goes on beyond all that is left of the displacement: then its reach need not be known.
bool EntityStep::outreaches(const LegHit& stop, bool back) const {
  if (stop.hit.side != Hit::Side::kSegment) return false;
  const Placement& placement = instances_.all()[stop.placement];
  const Point tangent = perpendicular(stop.hit.normal);
  return goesOnFor(maxNorm(rest_), placement.shape->bounds(), placement.position, placement.part->segments[stop.line],
                   back ? -tangent : tangent);
}

// How far home can slide, ahead or back, until the line that stopped it, or its end, lies no longer on the same edge of
// the shape.
Reach EntityStep::reachOf(const LegHit& stop, bool back) const {
  const Placement& placement = instances_.all()[stop.placement];
  const Segment& line = placement.part->segments[stop.line];
  const Point way = reachAlong(*placement.shape, placement.position, line, normalOf(stop), back);
  Reach reach;
  (back ? reach.behind : reach.ahead) = maxNorm(rotate(way, placement.toHome));
  return reach;
}

// The instance that met the line moves by its own rounding of the displacement, which could lead into the line again: a
// few subunits outwards prevent that. Bounds: normal < 2^30, displacement < 2^31.
Point EntityStep::outOf(const LegHit& stop, Point slid) const {
  const Placement& placement = instances_.all()[stop.placement];
  const Point outwards = dominantStep(homeNormalOf(stop));
  for (int steps = 0; steps < kNudge && slid != Point(); ++steps, slid += outwards) {
    if (dot(normalOf(stop), placement.at(position() + slid) - placement.position) >= 0) break;
  }
  return slid;
}

// Which way the entity slides along a line that it meets: towards the part of what it wants that the line leaves. Not
// scaled; zero when nothing is left.
Point EntityStep::slideDirection(const LegHit& hit) const {
  const Point tangent = perpendicular(homeNormalOf(hit));
  const std::int64_t along = dot(wanted_, tangent);
  return along == 0 ? Point() : along > 0 ? tangent : -tangent;
}

// Whether the way along this line leads into what stopped the entity, and not onwards; or has been tried from here.
bool EntityStep::leadsBack(const LegHit& line) const {
  const Point way = slideDirection(line);
  const bool intoStop = dot(way, homeNormalOf(*stop_)) < 0 && dot(way, slideDirection(*stop_)) <= 0;
  return intoStop || isSameLine(line, stop_) || isSameLine(line, stopBefore_);
}

// Whether the next line, which would stop the slide at `end`, leads back again, and nothing would be gained on the way.
// What is wanted rises with every other move, so that no sequence of them brings an entity that rests back to where it
// was.
bool EntityStep::isWedge(const LegHit& next, Point end) const {
  return dot(end - position(), wanted_) <= 0 && leadsBack(next);
}

// Whether a way to a line with this normal is longer than the lattice leaves open. Bounds: normal < 2^30, way < 2^31.
bool EntityStep::isApart(Point normal, Point way) {
  const int128 depth = dot(normal, way);
  return depth * depth > int128{kPlay * kPlay} * squaredLength(normal);
}

// Between two lines that each lead into the other, the lattice leaves places a little above both, and each line would
// send the entity to the other side in turn, for ever. A slide that gains nothing stops before it would be turned back.
Point EntityStep::shortOfTurning(Point target) {
  Point way = target - position();
  while (way != Point()) {
    const Point end = position() + way;
    const bool isFree = end == target || collider_.isFree(instances_, position(), end);
    if (isFree && (dot(way, wanted_) > 0 || !isTurnedBack(end))) return end;
    way = slideAlong({way.x / 2, way.y / 2}, homeNormalOf(*stop_));
  }
  return position();
}

bool EntityStep::isTurnedBack(Point end) {
  const Point target = end + wanted_;
  if (!allInRange(target)) return false;
  const auto next = collider_.first(instances_, end, target, &*stop_);
  return next && !isApart(homeNormalOf(*next), scaleTruncated(wanted_, next->hit.time)) && leadsBack(*next);
}

// Between two lines nothing is left of the displacement; but an end that can be passed is no wedge.
void EntityStep::restIn(const LegHit& next, const Way& way) {
  const LegHit stop = *stop_;
  if (passAlong(stop, next, way, position())) return;
  isFree_ = false;
  callContact(next);
  rest_ = Point();
}

bool EntityStep::isSameLine(const LegHit& a, const std::optional<LegHit>& b) {
  return b && a.placement == b->placement && a.line == b->line;
}

}  // namespace platon
