#pragma once

#include "tests/exactness/oracle/sweep/sweep_families.h"

namespace platon::oracle {

/// A strictly convex, counter-clockwise polygon. Most of its coordinates are below `scale` in magnitude.
Polygon randomShape(ShapeKind kind, std::int64_t scale, RandomSource& random);

/// A random segment of this kind, to be hit by `shape`. It may be out of the coordinate range: the caller checks that.
Segment randomSegment(SegmentKind kind, const Polygon& shape, std::int64_t scale, RandomSource& random);

}  // namespace platon::oracle
