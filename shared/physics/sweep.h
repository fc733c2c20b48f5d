#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shared/exact/fraction.h"
#include "shared/physics/convex.h"
#include "shared/physics/segment.h"

namespace platon {

/// The first meeting of a moving shape with a line.
struct Hit {
  /// Which edge of the obstacle was entered.
  enum class Side : std::uint8_t {
    kInside,     ///< none: the shape overlapped the line already
    kLine,       ///< a side of the line, with a vertex or a parallel edge of the shape
    kLineEnd,    ///< an end of the line (or a point), with an edge of the shape
  };

  Fraction time;             ///< of the displacement, in [0, 1)
  Fraction exit;             ///< when the shape leaves the line again, later than `time`; at most 1, which means later
  Point normal;              ///< outward normal of the edge entered; (0, 0) when inside. Below 2^30 a coordinate
  Point feature;             ///< what touches: kLine, a vertex of the shape, relative to its position; kLineEnd, the end
  Side side = Side::kInside;
};

/// The exact swept test: a convex shape S moves from `position` along `displacement`; a line L forbids the open
/// polygon L + (-S). The displacement is clipped against that polygon's edges, which are those of -S and both sides of
/// L; the polygon is never built and no interior point of the Minkowski sum is computed. No rounding anywhere.
///
/// Bounds: coordinates < 2^29, so |normal| < 2^30, normal . vertex and normal . position < 2^60 each and every signed
/// distance and speed below is < 2^62. Times compare through 128 bits.
class Sweep {
 public:
  /// Prepares for any number of lines. `grown` > 0 moves every edge of the obstacle outwards by at least that many
  /// subunits (by grown * (|nx| + |ny|) / |n|). The shape must outlive the sweep.
  void start(const Convex& shape, Point position, Point displacement, std::int32_t grown = 0);

  /// The first meeting with `line`: the infimum of the times in [0, 1] at which the open shape meets it. Touching, and
  /// a meeting that begins at time 1, are none. Where two edges are entered at once, the sides of the line win over
  /// its ends and earlier edges of the shape over later ones.
  std::optional<Hit> against(const Segment& line);

  /// All that the moving shape passes over, grown.
  const Box& bounds() const { return bounds_; }

 private:
  struct Clip;
  struct Extent {
    std::int64_t low, high;
  };
  bool passes(const Segment& line) const;
  bool clipSides(const Segment& line, Clip& clip) const;
  bool clipSides(const Segment& line, Extent extent, Clip& clip) const;
  bool clipEnds(const Segment& line, Clip& clip);
  void prepareEdges();
  Hit describe(const Segment& line, const Clip& clip) const;

  struct MovingEdge {
    Point normal;
    std::int64_t distance;  // of the start from the edge's line through the origin, grown
    std::int64_t speed;     // normal . displacement
  };

  const Convex* shape_ = nullptr;
  Point position_;
  Point displacement_;
  std::int32_t grown_ = 0;
  Box bounds_;
  std::vector<MovingEdge> edges_;   // empty until a line comes near enough to need them
};

}  // namespace platon
