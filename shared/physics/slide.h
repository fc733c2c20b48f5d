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

/// How far a slide may go along perpendicular(normal) and back, in subunits along the longer axis.
struct Reach {
  std::int32_t ahead = std::numeric_limits<std::int32_t>::max();
  std::int32_t behind = std::numeric_limits<std::int32_t>::max();
};

/// What is left of a displacement along an edge with outward normal `normal` (not zero, below 2^30): its part along the
/// edge, cut to whole subunits, then rounded to the outer side, so that it never leads inwards:
/// dot(result, normal) >= 0. (0, 0) when less than a subunit is left. |displacement| < 2^30 a coordinate. It ends a
/// subunit beyond `reach`.
Point slideAlong(Point displacement, Point normal, Reach reach = {});

/// How much of `whole`, not zero, has been covered by moving by `moved`, judged along the longer axis: 0 to 1.
Fraction shareOf(Point moved, Point whole);

/// `displacement * time`, cut; time is at most 1.
constexpr Point scaleTruncated(Point displacement, Fraction time) {
  if (time.numerator == 0) return {};  // what touches already, the most frequent of all
  return {scaleTruncated(displacement.x, time), scaleTruncated(displacement.y, time)};
}

/// The longer coordinate's magnitude.
inline std::int32_t maxNorm(Point vector) { return std::max(std::abs(vector.x), std::abs(vector.y)); }

/// `line` forbids `shape` a polygon; `position` touches its edge with outward normal `normal`. How far the position can
/// go along perpendicular(normal), or with `back` the other way, until that edge ends: in whole subunits, cut.
Point reachAlong(const Convex& shape, Point position, const Segment& line, Point normal, bool back);

/// Whether a line parallel to `tangent` goes on, ahead of all of a shape of these bounds, for more than twice as far as
/// a displacement of up to `longest` along either axis can lead: whatever frame it is measured in, and however rounded.
/// False may be an understatement. longest < 2^28, |tangent| < 2^30 a coordinate.
bool goesOnFor(std::int32_t longest, const Box& shape, Point position, const Segment& line, Point tangent);

/// `normal` turned and scaled so that its coordinates use 29 bits: within 2^-27 of the true direction.
Point turnedNormal(Point normal, Rotation direction);
inline Point turnedNormal(Point normal, Angle angle) { return turnedNormal(normal, rotationOf(angle)); }

/// One subunit along the axis in which `vector` is longest.
Point dominantStep(Point vector);

}  // namespace platon
