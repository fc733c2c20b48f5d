#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/segment.h"
#include "tests/exactness/oracle/random_source.h"

namespace platon::properties {

/// A symmetry of the lattice: an optional reflection (x becomes -x), then quarter turns, then a translation.
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
  Segment segment(const Segment& s) const { return {place(s.a), place(s.b)}; }
  /// A polygon relative to a position. A reflection reverses the order of its vertices, so that it stays
  /// counter-clockwise.
  std::vector<Point> shape(std::vector<Point> vertices) const {
    for (Point& vertex : vertices) vertex = vector(vertex);
    if (mirror) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }
};

/// A random symmetry, with a translation of up to `maxShift` along each axis.
inline LatticeMap anyMap(oracle::RandomSource& random, std::int64_t maxShift) {
  const oracle::Vec shift = random.vector(maxShift);
  return {random.oneIn(2),
          static_cast<int>(random.below(4)),
          {static_cast<std::int32_t>(shift.x), static_cast<std::int32_t>(shift.y)}};
}

}  // namespace platon::properties
