#include "shared/physics/sweep.h"

#include <algorithm>
#include <cstdlib>

namespace platon {
namespace {

// Takes from a meeting what lies outside a half plane to which the signed distance goes from `start` to `end`: one of
// them is negative, the other not.
void cut(Sweep::Meeting& meeting, std::int64_t start, std::int64_t end, std::size_t halfPlane) {
  if (start >= 0) {
    const Fraction time{start, start - end};
    if (meeting.entered != Sweep::Meeting::kNone && time <= meeting.enter) return;
    meeting.enter = time;
    meeting.entered = halfPlane;
  } else {
    meeting.endsInside = false;
    if (const Fraction time{-start, end - start}; time < meeting.exit) meeting.exit = time;
  }
}

}  // namespace

std::optional<Hit> Sweep::against(const Segment& line) {
  if (misses(boundsOf(line))) return std::nullopt;
  obstacle_.become(*shape_, line);
  return against(obstacle_);
}

std::optional<Hit> Sweep::against(Obstacle& obstacle) const {
  const auto meeting = meet(obstacle);
  return meeting ? std::optional(describe(obstacle, *meeting)) : std::nullopt;
}

std::optional<Sweep::Meeting> Sweep::clip(Obstacle& obstacle) const {
  Meeting meeting;
  for (const std::uint32_t i : obstacle.boundariesNear(way_)) {
    const Course course = courseOf(obstacle.halfPlanes()[i]);
    if (course.start < 0 && course.end < 0) continue;    // inside all the way
    if (course.start >= 0 && course.end >= 0) {          // outside all the way
      obstacle.expectBarrier(i);
      return std::nullopt;
    }
    cut(meeting, course.start, course.end, i);
  }
  if (!(meeting.enter < meeting.exit)) return std::nullopt;
  return meeting;
}

Hit Sweep::describe(const Obstacle& obstacle, const Meeting& meeting) {
  Hit hit{.time = meeting.enter, .exit = meeting.exit, .normal = {}, .feature = {}, .side = Hit::Side::kInside};
  if (meeting.entered == Meeting::kNone) return hit;
  const Segment& line = obstacle.line();
  hit.normal = obstacle.halfPlanes()[meeting.entered].normal;
  if (meeting.entered < obstacle.sides()) {
    hit.side = Hit::Side::kLine;
    hit.feature = obstacle.featureOfSide(meeting.entered);
    return hit;
  }
  const std::int64_t alongLine = dot(hit.normal, line.b - line.a);
  hit.side = alongLine == 0 && line.a != line.b ? Hit::Side::kLine : Hit::Side::kLineEnd;
  hit.feature = hit.side == Hit::Side::kLine ? obstacle.shape().vertices()[meeting.entered - obstacle.sides()]
                : alongLine > 0              ? line.b
                                             : line.a;
  return hit;
}

}  // namespace platon
