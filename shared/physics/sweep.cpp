#include "platon/physics/sweep.h"

namespace platon {
namespace {

Hit makeHit(const Sweep::ClipInterval& interval, Point normal, Point feature, Hit::Side side) {
  return {.time = interval.enter, .exit = interval.exit, .normal = normal, .feature = feature, .side = side};
}

Hit insideHit(const Sweep::ClipInterval& interval) { return makeHit(interval, {}, {}, Hit::Side::kInside); }

// The hit of an edge of the shape on an end of the segment, or on its side when the two are parallel. After a clip, the
// side itself comes first; an ideal path that starts inside compares rounded depths, and may name the edge.
Hit edgeHit(const Sweep::ClipInterval& interval, const Convex& shape, std::size_t edge, const Segment& segment) {
  const Point normal = shape.edges()[edge].normal;
  const std::int64_t along = dot(normal, segment.b - segment.a);
  if (along == 0 && segment.a != segment.b) {
    return makeHit(interval, normal, shape.vertices()[edge], Hit::Side::kSegment);
  }
  return makeHit(interval, normal, along > 0 ? segment.b : segment.a, Hit::Side::kSegmentEnd);
}

}  // namespace

// Intersects `interval` with a half plane whose boundary the displacement crosses.
void Sweep::cross(ClipInterval& interval, EndDistances distances, std::size_t halfPlane) {
  if (distances.start >= 0) {
    const Fraction time{distances.start, distances.start - distances.end};
    if (interval.entered != ClipInterval::kNone && time <= interval.enter) return;
    interval.enter = time;
    interval.entered = halfPlane;
  } else {
    const Fraction time{-distances.start, distances.end - distances.start};
    if (interval.endsInside || time < interval.exit) interval.exit = time;
    interval.endsInside = false;
  }
}

// Whether the interval has no interior. It has one when the displacement starts or ends inside.
bool Sweep::isEmpty(const ClipInterval& interval) {
  return interval.entered != ClipInterval::kNone && !interval.endsInside && interval.enter >= interval.exit;
}

std::optional<Hit> Sweep::against(const Segment& segment) const {
  if (misses(boundsOf(segment))) return std::nullopt;
  const auto interval = clipToSegment(segment, [](const Obstacle::HalfPlane&) {});
  return interval ? std::optional(hitOf(*shape_, segment, *interval)) : std::nullopt;
}

std::optional<Sweep::ClipInterval> Sweep::clip(const Segment& segment, Obstacle::HalfPlane& separating) const {
  return clipToSegment(segment, [&](const Obstacle::HalfPlane& half) {
    separating = {half.normal, half.offset - dot(half.normal, position_)};
  });
}

// Calls `separates` with the half plane that alone excludes the displacement, relative to the position.
template <class Separates>
std::optional<Sweep::ClipInterval> Sweep::clipToSegment(const Segment& segment, Separates&& separates) const {
  const Segment relative{segment.a - position_, segment.b - position_};  // saves the products with position_
  ClipInterval interval;
  std::size_t index = 0;
  const auto excludes = [&](const Obstacle::HalfPlane& half) {
    if (intersect(interval, endDistances(half.offset, half), index++)) return false;
    separates(half);
    return true;
  };
  if (segment.a != segment.b) {
    for (const Obstacle::HalfPlane& side : Obstacle::sideHalfPlanes(*shape_, relative)) {
      if (excludes(side)) return std::nullopt;
    }
  }
  for (const Convex::Edge& edge : shape_->edges()) {
    if (excludes(Obstacle::edgeHalfPlane(edge, relative))) return std::nullopt;
  }
  if (isEmpty(interval)) return std::nullopt;
  return interval;
}

Hit Sweep::hitOf(const Convex& shape, const Segment& segment, const ClipInterval& interval) {
  if (interval.entered == ClipInterval::kNone) return insideHit(interval);
  const std::size_t sides = segment.a == segment.b ? 0 : 2;
  if (interval.entered >= sides) return edgeHit(interval, shape, interval.entered - sides, segment);
  const Point left = perpendicular(segment.b - segment.a);
  const Point normal = interval.entered == 0 ? left : -left;
  return makeHit(interval, normal, Obstacle::sideFeature(shape, normal), Hit::Side::kSegment);
}

std::optional<Hit> Sweep::against(Obstacle& obstacle) const {
  const auto interval = clip(obstacle);
  return interval ? std::optional(hitOf(obstacle, *interval)) : std::nullopt;
}

std::optional<Sweep::ClipInterval> Sweep::clipToHalfPlanes(Obstacle& obstacle) const {
  ClipInterval interval;
  const bool mayOverlap = obstacle.visitRelevant(path_, [&](std::size_t i) {
    if (intersect(interval, endDistancesTo(obstacle.halfPlane(i)), i)) return true;
    obstacle.setSeparatingHint(i);
    return false;
  });
  if (!mayOverlap || isEmpty(interval)) return std::nullopt;
  return interval;
}

Hit Sweep::hitOf(const Obstacle& obstacle, const ClipInterval& interval) {
  if (interval.entered == ClipInterval::kNone) return insideHit(interval);
  if (interval.entered >= obstacle.sideCount()) {
    return edgeHit(interval, obstacle.shape(), interval.entered - obstacle.sideCount(), obstacle.segment());
  }
  return makeHit(interval, obstacle.halfPlane(interval.entered).normal, obstacle.sideFeature(interval.entered),
                 Hit::Side::kSegment);
}

}  // namespace platon
