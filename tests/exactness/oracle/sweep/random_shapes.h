#pragma once

#include "tests/exactness/oracle/sweep/sweep_families.h"

namespace platon::oracle {

/// A strictly convex, counter-clockwise polygon. Most of its coordinates are below `scale` in magnitude.
Polygon randomShape(ShapeKind kind, std::int64_t scale, RandomSource& random);

/// A segment as obstacle for this polygon. It may be out of the coordinate range: the caller checks that.
Segment randomObstacle(ObstacleKind kind, const Polygon& shape, std::int64_t scale, RandomSource& random);

}  // namespace platon::oracle
