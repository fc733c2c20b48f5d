#pragma once

#include "tests/exactness/oracle/sweep/sweep_families.h"

namespace platon::oracle {

/// A strictly convex counter-clockwise polygon whose coordinates are mostly below `scale` in magnitude.
Polygon randomShape(ShapeKind kind, std::int64_t scale, RandomSource& random);

/// An obstacle for this polygon. May leave the coordinate range; the caller checks.
Segment randomLine(LineKind kind, const Polygon& shape, std::int64_t scale, RandomSource& random);

}  // namespace platon::oracle
