#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/segment.h"
#include "tests/exactness/oracle/random_source.h"

namespace platon::properties {

/// A motion of the plane that takes lattice points to lattice points: first a mirror (x becomes -x), then quarter
/// turns, then a shift.
struct LatticeMap {
  bool mirror = false;
  int quarters = 0;  ///< counter-clockwise, 0 … 3
  Point shift;

  Point vector(Point v) const {
    if (mirror) v.x = -v.x;
    for (int i = 0; i < quarters; ++i) v = perpendicular(v);
    return v;
  }
  Point place(Point p) const { return vector(p) + shift; }
  Segment line(const Segment& line) const { return {place(line.a), place(line.b)}; }
  /// A polygon round a position; a mirror turns its order round, so that it is counter-clockwise again.
  std::vector<Point> shape(std::vector<Point> vertices) const {
    for (Point& vertex : vertices) vertex = vector(vertex);
    if (mirror) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }
};

/// Shifted by `farthest` along each axis at most.
inline LatticeMap anyMap(oracle::RandomSource& random, std::int64_t farthest) {
  const oracle::Vec shift = random.vector(farthest);
  return {random.oneIn(2),
          static_cast<int>(random.below(4)),
          {static_cast<std::int32_t>(shift.x), static_cast<std::int32_t>(shift.y)}};
}

}  // namespace platon::properties
