#include "platon/physics/sweep.h"

namespace platon {
namespace {

Hit hitOf(const Sweep::Meeting& meeting, Point normal, Point feature, Hit::Side side) {
  return {.time = meeting.enter, .exit = meeting.exit, .normal = normal, .feature = feature, .side = side};
}

Hit inside(const Sweep::Meeting& meeting) { return hitOf(meeting, {}, {}, Hit::Side::kInside); }

// Of an edge of the shape that touches an end of the line, or all of it when the two are parallel.
Hit hitByEdge(const Sweep::Meeting& meeting, const Convex& shape, std::size_t edge, const Segment& line) {
  const Point normal = shape.edges()[edge].normal;
  const std::int64_t alongLine = dot(normal, line.b - line.a);
  if (alongLine == 0 && line.a != line.b) return hitOf(meeting, normal, shape.vertices()[edge], Hit::Side::kSegment);
  return hitOf(meeting, normal, alongLine > 0 ? line.b : line.a, Hit::Side::kSegmentEnd);
}

}  // namespace

// One half plane more, which the way crosses.
void Sweep::cross(Meeting& meeting, Course course, std::size_t halfPlane) {
  if (course.start >= 0) {
    const Fraction time{course.start, course.start - course.end};
    if (meeting.entered != Meeting::kNone && time <= meeting.enter) return;
    meeting.enter = time;
    meeting.entered = halfPlane;
  } else {
    const Fraction time{-course.start, course.end - course.start};
    if (meeting.endsInside || time < meeting.exit) meeting.exit = time;
    meeting.endsInside = false;
  }
}

// Whether nothing of the way is inside. What comes in and stays, or is in from the beginning, is in for some time.
bool Sweep::isEmpty(const Meeting& meeting) {
  return meeting.entered != Meeting::kNone && !meeting.endsInside && meeting.enter >= meeting.exit;
}

std::optional<Hit> Sweep::against(const Segment& line) const {
  if (misses(boundsOf(line))) return std::nullopt;
  const Segment seen{line.a - position_, line.b - position_};  // from the position: it needs no product of its own
  Meeting meeting;
  std::size_t sides = 0;
  if (line.a != line.b) {
    for (const Obstacle::HalfPlane& side : Obstacle::ofSides(*shape_, seen)) {
      if (!clip(meeting, courseFrom(side.offset, side), sides++)) return std::nullopt;
    }
  }
  for (std::size_t edge = 0; edge < shape_->edges().size(); ++edge) {
    const auto half = Obstacle::ofEdge(shape_->edges()[edge], seen);
    if (!clip(meeting, courseFrom(half.offset, half), sides + edge)) return std::nullopt;
  }
  if (isEmpty(meeting)) return std::nullopt;
  if (meeting.entered == Meeting::kNone) return inside(meeting);
  if (meeting.entered >= sides) return hitByEdge(meeting, *shape_, meeting.entered - sides, line);
  const Point left = perpendicular(line.b - line.a);
  const Point normal = meeting.entered == 0 ? left : -left;
  return hitOf(meeting, normal, Obstacle::featureOfSide(*shape_, normal), Hit::Side::kSegment);
}

std::optional<Hit> Sweep::against(Obstacle& obstacle) const {
  const auto meeting = meet(obstacle);
  return meeting ? std::optional(describe(obstacle, *meeting)) : std::nullopt;
}

std::optional<Sweep::Meeting> Sweep::clip(Obstacle& obstacle) const {
  Meeting meeting;
  for (const std::uint32_t i : obstacle.boundariesNear(way_)) {
    if (clip(meeting, courseOf(obstacle.halfPlanes()[i]), i)) continue;
    obstacle.setSeparatingHint(i);
    return std::nullopt;
  }
  if (isEmpty(meeting)) return std::nullopt;
  return meeting;
}

Hit Sweep::describe(const Obstacle& obstacle, const Meeting& meeting) {
  if (meeting.entered == Meeting::kNone) return inside(meeting);
  if (meeting.entered >= obstacle.sides()) {
    return hitByEdge(meeting, obstacle.shape(), meeting.entered - obstacle.sides(), obstacle.line());
  }
  return hitOf(meeting, obstacle.halfPlanes()[meeting.entered].normal, obstacle.featureOfSide(meeting.entered),
               Hit::Side::kSegment);
}

}  // namespace platon
