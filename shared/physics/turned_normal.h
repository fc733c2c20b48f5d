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

/// `displacement * time` with both coordinates rounded towards zero. Requires 0 <= time <= 1.
constexpr Point scaleTruncated(Point displacement, Fraction time) {
  if (time.numerator == 0) return {};  // fast path: the shape usually touches the segment already
  return {scaleTruncated(displacement.x, time), scaleTruncated(displacement.y, time)};
}

/// The larger of |x| and |y|.
inline std::int32_t maxNorm(Point vector) { return std::max(std::abs(vector.x), std::abs(vector.y)); }

/// `normal` rotated and scaled so that the larger coordinate uses 29 bits. The direction is exact to 2^-27.
Point turnedNormal(Point normal, Rotation rotation);
inline Point turnedNormal(Point normal, Angle angle) { return turnedNormal(normal, rotationOf(angle)); }

}  // namespace platon
