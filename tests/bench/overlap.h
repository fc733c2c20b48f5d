#pragma once

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

/// Largest distance, over the normals of all sides, by which `shape` at (x, y) is separated from the segment. If they
/// overlap it is negative: the penetration depth. Subunits.
long double separationOf(const Convex& shape, long double x, long double y, const Segment& line);

/// Penetration depth of `shape` at (x, y); 0 if it does not overlap the segment. Subunits.
double overlapOf(const Convex& shape, long double x, long double y, const Segment& line);

}  // namespace platon::bench
