#include "shared/physics/step/segment_ends.h"

#include <algorithm>
#include <cstdlib>
#include <span>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/step/hit_frame.h"
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
int128 squaredSlide(const Slide& slide, const LegHit& hit) {
  return squared(alongEdge(homeNormalOf(slide.instances, hit), slide.remaining));
}

// Whether the shape is too small for nudges: it could be nudged back and forth between the two sides of an end.
bool isTiny(const Convex& shape) {
  const Point size = shape.bounds().high - shape.bounds().low;
  return std::max(size.x, size.y) < 8 * kNudge;
}

bool isImmediate(const Hit& hit, Point displacement) {
  return squaredLength(scaleTruncated(displacement, hit.time)) <= squaredLength(Point(kNudge, kNudge));
}

// The search for a nudge past the end that `end` touches.
class EndPassage {
 public:
  EndPassage(Mover& mover, PrecisePoint tick, const LegHit& end, PrecisePoint ideal)
      : mover_(mover),
        collider_(mover.collider()),
        instances_(mover.instances()),
        tick_(tick),
        end_(end),
        ideal_(ideal) {}

  /// Whether the body touches an end of the segment at its ideal place, perhaps with a vertex. If so, the hit becomes
  /// one of that end, as `nudge` requires.
  bool touchesEnd();
  /// The normal of the end in the frame of the home part.
  Point normal() const { return homeNormalOf(instances_, end_); }
  /// The position, at most kNudge subunits beside `reached`, from which the segment end is passed. The path must
  /// continue from there, so that an entity at rest is not nudged back and forth, and must lead past the end.
  std::optional<Point> nudge(Point reached, Point target);

 private:
  bool isAtJoint();
  bool grazes(Point reached, Point target) const;
  bool isAhead(Point place) const;
  bool continuesPast(Point from, Point to);
  bool hitsEndAgain(Point from, Point to);
  Point awayFromEnd() const;

  Mover& mover_;
  Collider& collider_;
  const Instances& instances_;
  PrecisePoint tick_;
  LegHit end_;
  PrecisePoint ideal_;
};

bool EndPassage::touchesEnd() {
  if (end_.hit.side == Hit::Side::kSegmentEnd) return true;
  const Segment& segment = segmentOf(instances_, end_);
  const ObstacleEdge& edge = end_.edge;
  const Point tangent = perpendicular(edge.half.normal);
  const PrecisePoint there = instances_.idealOf(end_.placement, ideal_);
  const int128 near = int128{Tolerances::kNoProgress} * (std::abs(tangent.x) + std::abs(tangent.y));
  const bool isHigh = distanceTo({tangent, -edge.high}, there) >= -near;
  if (!isHigh && distanceTo({tangent, -edge.low}, there) > near) return false;
  end_.hit.side = Hit::Side::kSegmentEnd;
  end_.hit.feature = (dot(tangent, segment.b - segment.a) > 0) == isHigh ? segment.b : segment.a;
  return true;
}

std::optional<Point> EndPassage::nudge(Point reached, Point target) {
  if (isTiny(*placementOf(instances_, end_).shape) || !grazes(reached, target) || !isAtJoint()) return std::nullopt;
  const Point position = mover_.position();
  for (const Point offset : std::span(kNudgeOffsets).subspan(1)) {
    const Point from = reached + offset;
    const Point to = target + offset;
    if (!isAhead(to) || dot(to - position, normal()) >= 0 || !mover_.allInRange(to)) continue;
    if (continuesPast(from, to) && mover_.isFree(position, from) && mover_.mayBeAt(from)) return from;
  }
  return std::nullopt;
}

// Whether another segment, perhaps on a neighbouring face, reaches the end. An end that stands alone stops the body, as
// it stops the ideal one.
bool EndPassage::isAtJoint() {
  const Placement& own = placementOf(instances_, end_);
  if (collider_.hasSegmentNear(own, end_.hit.feature, Tolerances::kJoint, end_.segment)) return true;
  const Point end = rotate(end_.hit.feature - own.position, own.toHome);  // from the position of the body
  return std::any_of(instances_.all().begin(), instances_.all().end(), [&](const Placement& other) {
    return &other != &own && collider_.hasSegmentNear(other, other.position + rotate(end, other.fromHome),
                                                      Tolerances::kJointAcross, Collider::kNoSegment);
  });
}

// Whether the segment end is within kNudge of a flank of the shape. Otherwise no nudge can clear it.
// Bounds: side < 2^30, differences < 2^31, so that products are < 2^62.
bool EndPassage::grazes(Point reached, Point target) const {
  const Placement& placement = placementOf(instances_, end_);
  const Point from = placement.at(reached);
  const Point side = perpendicular(placement.at(target) - from);
  const Point feature = end_.hit.feature - from;
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

// Whether the tick leads from the ideal place to this one rather than back.
bool EndPassage::isAhead(Point place) const {
  const PrecisePoint gained = precise(place) - ideal_;
  return int128{gained.x} * tick_.x + int128{gained.y} * tick_.y > 0;
}

// Whether the path from `from` to `to` passes the end and then either leads ahead, to its end or to the next segment,
// or slides along the segment, away from the end. Legs never lead back, so a body that rests is not nudged for ever.
bool EndPassage::continuesPast(Point from, Point to) {
  if (hitsEndAgain(from, to)) return false;
  const auto next = collider_.first(instances_, from, to);
  if (!next) return true;
  if (next->placement != end_.placement || next->segment != end_.segment)
    return !isImmediate(next->hit, to - from) && isAhead(from + scaleTruncated(to - from, next->hit.time));
  const Point tangent = perpendicular(homeNormalOf(instances_, *next));
  const Point direction = distanceTo({tangent, 0}, tick_) >= 0 ? tangent : -tangent;
  return next->hit.side == Hit::Side::kSegment && dot(direction, to - from) > 0 && dot(direction, awayFromEnd()) > 0;
}

// Fast path of continuesPast: whether the path immediately hits the same end again, which is usual.
bool EndPassage::hitsEndAgain(Point from, Point to) {
  const Placement& placement = placementOf(instances_, end_);
  const auto again = collider_.hit(placement, {placement.at(from), placement.at(to)}, end_.segment);
  return again && again->side != Hit::Side::kSegment && isImmediate(*again, to - from);
}

// The vector from the end that was hit to the other end, in the frame of the home part. Coordinates below 2^30.
Point EndPassage::awayFromEnd() const {
  const Segment& segment = segmentOf(instances_, end_);
  const Point along = segment.a == end_.hit.feature ? segment.b - segment.a : segment.a - segment.b;
  return rotate(along, placementOf(instances_, end_).toHome);
}

}  // namespace

bool isBlockedByEnd(const Slide& slide, const LegHit& hit, PrecisePoint place, PrecisePoint remaining) {
  if (hit.hit.side != Hit::Side::kSegmentEnd) return false;
  const int128 before = slide.contact ? squaredSlide(slide, *slide.contact) : squared(slide.remaining);
  if (1024 * squaredSlide(slide, hit) >= before) return false;
  const EdgeSlide along = slide.slideFrom(hit, place, remaining);
  return !along.cut || along.share > Fraction{1, 32};
}

std::optional<Nudge> findNudge(Mover& mover, const Slide& slide, const LegHit& hit, Point normal, PrecisePoint from,
                               PrecisePoint remaining) {
  EndPassage passage(mover, slide.tick, hit, from);
  if (!passage.touchesEnd()) return std::nullopt;
  const bool straight = normal == passage.normal();
  const PrecisePoint onwards = straight ? remaining : alongEdge(normal, remaining);
  const Point reached = mover.roundedAt(from);
  const Point target = reached + rounded(onwards);
  if (target == reached || !mover.allInRange(target)) return std::nullopt;
  const auto to = passage.nudge(reached, target);
  return to ? std::optional(Nudge{*to, target - reached}) : std::nullopt;
}

}  // namespace platon
