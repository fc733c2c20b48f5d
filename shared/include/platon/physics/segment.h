#pragma once

#include <algorithm>

#include "platon/exact/point.h"

namespace platon {

/// A line of a map part in subunits. Both ends equal make a point, which blocks too.
struct Segment {
  Point a;
  Point b;

  friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// A closed axis-aligned box in subunits.
struct Box {
  Point low;
  Point high;

  constexpr bool overlaps(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
  constexpr bool contains(const Box& other) const {
    return low.x <= other.low.x && other.high.x <= high.x && low.y <= other.low.y && other.high.y <= high.y;
  }
  constexpr Box grown(std::int32_t margin) const { return {low - Point(margin, margin), high + Point(margin, margin)}; }
  /// The box moved along `displacement`, with all it passes over.
  constexpr Box swept(Point displacement) const {
    return {{low.x + std::min(displacement.x, 0), low.y + std::min(displacement.y, 0)},
            {high.x + std::max(displacement.x, 0), high.y + std::max(displacement.y, 0)}};
  }
};

constexpr Box boundsOf(const Segment& line) {
  return {{std::min(line.a.x, line.b.x), std::min(line.a.y, line.b.y)},
          {std::max(line.a.x, line.b.x), std::max(line.a.y, line.b.y)}};
}

}  // namespace platon
