#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "platon/exact/fraction.h"
#include "platon/exact/integer.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/convex.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"
#include "platon/physics/sweep.h"

namespace platon {

/// The geometry of the ideal path: exact up to 2^-26 subunits. The lattice follows it (docs/exactness.md).

/// `numerator / denominator` as a fraction, to 60 significant bits; at least 0. Requires denominator > 0.
Fraction fractionOf(int128 numerator, int128 denominator);

/// `vector * share`, rounded. Requires 0 < share < 1 and |vector| < 2^60.
PrecisePoint scaledInside(PrecisePoint vector, Fraction share);
/// The same. Requires 0 <= share <= 1. Fast at both ends of that range, which are usual.
inline PrecisePoint scaled(PrecisePoint vector, Fraction share) {
  if (share.numerator == share.denominator) return vector;
  return share.numerator == 0 ? PrecisePoint() : scaledInside(vector, share);
}

/// Signed distance of `point` from a half plane, times the length of its normal, in 2^-26 subunits. Negative inside.
int128 distanceTo(const Obstacle::HalfPlane& half, PrecisePoint point);

/// The half planes of the obstacle of `segment` for `shape`, as Obstacle numbers them.
Obstacle::HalfPlane halfPlaneOf(const Convex& shape, const Segment& segment, std::size_t index);

/// Where a path enters an obstacle.
struct IdealEntry {
  Fraction time;     ///< as a fraction of the displacement, in [0, 1]
  std::size_t edge;  ///< index of the half plane whose edge is entered

  friend bool operator==(const IdealEntry&, const IdealEntry&) = default;
};

/// Where the ideal path enters the obstacle of `segment` for `shape`. A path that starts inside enters at once, through
/// the nearest edge, unless it leaves through it. Within Tolerances::kOnEdge of an edge is outside.
std::optional<IdealEntry> clipIdeal(const Convex& shape, const Segment& segment, PrecisePoint from,
                                    PrecisePoint displacement);
/// The edge of the obstacle that a path enters at once because it starts on it, more than a subunit inside of all other
/// half planes: `clipIdeal` finds the same. Nothing in all other cases. `positions` must contain the start.
std::optional<std::size_t> touchedEdge(Obstacle& obstacle, const Box& positions, PrecisePoint from,
                                       PrecisePoint displacement);

/// As `clipIdeal` above with a prebuilt obstacle. `positions` must contain the path.
std::optional<IdealEntry> clipIdeal(Obstacle& obstacle, const Box& positions, PrecisePoint from,
                                    PrecisePoint displacement);

/// An edge of an obstacle: its half plane, and where it begins and ends along perpendicular(normal).
struct ObstacleEdge {
  Obstacle::HalfPlane half;
  std::int64_t low = 0;   ///< dot(perpendicular(normal), first corner)
  std::int64_t high = 0;  ///< the same of the last corner
};
ObstacleEdge edgeOf(const Convex& shape, const Segment& segment, const Obstacle::HalfPlane& half);
/// The index of the next half plane of the same obstacle, counter-clockwise or, with `back`, clockwise.
std::size_t adjacent(const Convex& shape, const Segment& segment, Point normal, bool back);

/// The component of `displacement` along an edge with this normal.
PrecisePoint alongEdge(Point normal, PrecisePoint displacement);

/// How far a slide along an edge wants to go and may go, times the length of the normal, in 2^-26 subunits.
struct SlideRoom {
  int128 wanted = 0;  ///< at least 0
  int128 left = 0;    ///< to the end of the edge; negative beyond it
  bool back = false;  ///< it goes against perpendicular(normal)

  bool isEnough() const { return wanted <= left; }
};
SlideRoom roomOn(const ObstacleEdge& edge, PrecisePoint from, PrecisePoint remaining);

/// A slide along an edge.
struct EdgeSlide {
  PrecisePoint displacement;  ///< the component of the remaining displacement along the edge, up to the edge's end
  Fraction share{1, 1};       ///< of the displacement that the slide uses
  bool back = false;          ///< it goes against perpendicular(normal)
  bool cut = false;           ///< it ends with the edge
};
EdgeSlide slideAlong(const ObstacleEdge& edge, PrecisePoint from, PrecisePoint remaining);

/// `point`, moved onto the line of the edge if it is farther from it than Tolerances::kRounding.
PrecisePoint putOnto(const Obstacle::HalfPlane& half, PrecisePoint point);

}  // namespace platon
