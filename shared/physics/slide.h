#pragma once

#include "shared/exact/angle.h"
#include "shared/exact/point.h"

namespace platon {

/// What is left of a displacement along an edge with outward normal `normal` (not zero, below 2^30): its part along the
/// edge, cut to whole subunits, then rounded to the outer side, so that it never leads inwards:
/// dot(result, normal) >= 0. (0, 0) when less than a subunit is left. |displacement| < 2^30 a coordinate.
Point slideAlong(Point displacement, Point normal);

/// `normal` turned by `angle` and scaled so that its coordinates use 29 bits: within 2^-27 of the true direction.
Point turnedNormal(Point normal, Angle angle);

/// One subunit along the axis in which `vector` is longest.
Point dominantStep(Point vector);

}  // namespace platon
