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

/// How far a slide may go along perpendicular(normal) and in the opposite direction, in subunits along the dominant
/// axis.
struct SlideLimits {
  std::int32_t forward = std::numeric_limits<std::int32_t>::max();
  std::int32_t backward = std::numeric_limits<std::int32_t>::max();
};

/// The component of `displacement` along an edge with outward normal `normal`, truncated to whole subunits along the
/// dominant axis and rounded outwards along the other: dot(result, normal) >= 0. At most one subunit longer than
/// `limits`. (0, 0) when the component is shorter than a subunit. Requires |displacement| < 2^30 and |normal| < 2^30
/// per coordinate, and normal != (0, 0).
Point slideAlong(Point displacement, Point normal, SlideLimits limits = {});

/// The fraction of the displacement `whole` that the displacement `moved` covers, measured along the dominant axis of
/// `whole` and clamped to [0, 1]. Requires whole != (0, 0).
Fraction fractionCovered(Point moved, Point whole);

/// `displacement * time` with both coordinates rounded towards zero. Requires 0 <= time <= 1.
constexpr Point scaleTruncated(Point displacement, Fraction time) {
  if (time.numerator == 0) return {};  // fast path: the shape usually touches the segment already
  return {scaleTruncated(displacement.x, time), scaleTruncated(displacement.y, time)};
}

/// The larger of |x| and |y|.
inline std::int32_t maxNorm(Point vector) { return std::max(std::abs(vector.x), std::abs(vector.y)); }

/// The displacement from `position` to the end of the obstacle edge that it touches. The obstacle is that of `segment`
/// for `shape`; the edge has the outward normal `normal`. Measured along perpendicular(normal), or against it with
/// `back`, and truncated to whole subunits.
Point displacementToEdgeEnd(const Convex& shape, Point position, const Segment& segment, Point normal, bool back);

/// Whether `segment`, which is parallel to `tangent`, extends beyond a shape with bounding box `shape` at `position` by
/// more than twice any displacement whose coordinates are at most `longest`, in any frame and after rounding. A
/// conservative test: false does not imply the opposite. Requires longest < 2^28 and |tangent| < 2^30 per coordinate.
bool extendsBeyond(std::int32_t longest, const Box& shape, Point position, const Segment& segment, Point tangent);

/// `normal` rotated and scaled so that the larger coordinate uses 29 bits. The direction is exact to 2^-27.
Point turnedNormal(Point normal, Rotation rotation);
inline Point turnedNormal(Point normal, Angle angle) { return turnedNormal(normal, rotationOf(angle)); }

/// The unit vector along the dominant axis of `vector`.
Point dominantStep(Point vector);

}  // namespace platon
