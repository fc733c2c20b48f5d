#pragma once

#include <algorithm>
#include <cstdint>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A wall of a map part, in subunits. Equal ends make a point, which blocks too.
struct Segment {
  Point a;
  Point b;

  friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// The coordinates of a normal of a segment or of a shape are below this in magnitude: it is the difference of two
/// points, rotated by 90°. Its length has no meaning.
inline constexpr std::int32_t kNormalLimit = 2 * kCoordinateLimit;

/// A closed axis-aligned box in subunits.
struct Box {
  Point low;
  Point high;

  /// Whether the boxes have a point in common; touching counts.
  constexpr bool overlaps(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
  constexpr bool contains(const Box& other) const {
    return low.x <= other.low.x && other.high.x <= high.x && low.y <= other.low.y && other.high.y <= high.y;
  }
  /// The bounding box of both boxes.
  constexpr Box joined(const Box& other) const {
    return {{std::min(low.x, other.low.x), std::min(low.y, other.low.y)},
            {std::max(high.x, other.high.x), std::max(high.y, other.high.y)}};
  }
  /// The box enlarged by `margin` on every side.
  constexpr Box grown(std::int32_t margin) const { return {low - Point(margin, margin), high + Point(margin, margin)}; }
  /// The bounding box of this box moved along `displacement`.
  constexpr Box swept(Point displacement) const {
    return {{low.x + std::min(displacement.x, 0), low.y + std::min(displacement.y, 0)},
            {high.x + std::max(displacement.x, 0), high.y + std::max(displacement.y, 0)}};
  }
};

/// The bounding box of `segment`.
constexpr Box boundsOf(const Segment& segment) {
  return {{std::min(segment.a.x, segment.b.x), std::min(segment.a.y, segment.b.y)},
          {std::max(segment.a.x, segment.b.x), std::max(segment.a.y, segment.b.y)}};
}

/// Whether a segment has a point in common with a box; touching counts. Requires coordinates up to 2^29.
constexpr bool touches(const Segment& segment, const Box& box) {
  if (!box.overlaps(boundsOf(segment))) return false;
  const Point along = segment.b - segment.a;
  const auto side = [&](std::int32_t x, std::int32_t y) { return cross(along, Point(x, y) - segment.a); };
  const auto [low, high] = std::minmax({side(box.low.x, box.low.y), side(box.low.x, box.high.y),
                                        side(box.high.x, box.low.y), side(box.high.x, box.high.y)});
  return low <= 0 && high >= 0;
}

}  // namespace platon
