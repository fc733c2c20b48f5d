#pragma once

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

/// How far `shape`, at (x, y), is from the line along the direction in which that is most; where it overlaps, the
/// shortest way out, negative. Subunits.
long double separationOf(const Convex& shape, long double x, long double y, const Segment& line);

/// How deep it is in the line; 0 when it is outside or touches. Subunits.
double overlapOf(const Convex& shape, long double x, long double y, const Segment& line);

}  // namespace platon::bench
