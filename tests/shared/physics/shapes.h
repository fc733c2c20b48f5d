#pragma once

#include <cstdint>
#include <vector>

#include "platon/physics/convex.h"
#include "tests/sim/seeded_random.h"

namespace platon {

/// A square centred on the origin with sides of length 2 * `reach`.
inline Convex square(std::int32_t reach) {
  return Convex(std::vector<Point>{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}});
}

/// The regular polygon with this circumradius, rounded to the lattice. An edge is at the bottom.
inline Convex regular(int count, std::int32_t radius) {
  std::vector<Point> vertices;
  const std::int32_t step = Angle::kTurn / count;
  for (int i = 0; i < count; ++i) vertices.push_back(rotate(Point(radius, 0), Angle(-9000 + step / 2 + i * step)));
  return Convex(vertices);
}

/// The convex hull of 3 to 12 random points around `middle`.
inline Convex randomConvex(sim::SeededRandom& random, std::int32_t radius, Point middle = {}) {
  for (;;) {
    std::vector<Point> points;
    const std::uint64_t count = 3 + random.below(10);
    for (std::uint64_t i = 0; i < count; ++i) points.push_back(middle + random.vector(radius));
    auto hull = convexHull(points);
    if (!Convex::fault(hull)) return Convex(std::move(hull));
  }
}

}  // namespace platon
