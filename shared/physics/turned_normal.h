#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "platon/exact/angle.h"
#include "platon/exact/fraction.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon {

/// `normal` rotated and scaled so that the larger coordinate uses 29 bits. The direction is exact to 2^-27.
Point turnedNormal(Point normal, Rotation rotation);
inline Point turnedNormal(Point normal, Angle angle) { return turnedNormal(normal, rotationOf(angle)); }

}  // namespace platon
