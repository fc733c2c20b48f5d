#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/physics/segment.h"

namespace platon {

/// A point of a level text before rounding, in 1/625 subunits: 0.0001 level units are 64 of them.
struct FinePoint {
  static constexpr std::int64_t kPerSubunit = 625;
  static constexpr std::int64_t kPerTenThousandth = 64;

  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// The polygon of a face; clips lines at its edges. Exact, except that each end of a line is rounded once.
class FaceArea {
 public:
  /// Largest magnitude of the coordinates that `clip` accepts, in level units: twice the largest face size.
  static constexpr std::int32_t kMaxUnits = 131072;

  /// `polygon` is convex and counter-clockwise; its coordinates are below 2^26.
  explicit FaceArea(std::span<const Point> polygon);

  /// True when the point is inside the polygon or on its edge.
  bool contains(Point point) const;

  /// The part of the line a–b on the face, its ends rounded to subunits. An end that is at most one subunit outside is
  /// kept; any other end outside moves to the lattice point nearest to where the line meets the edge. A line that runs
  /// along an edge at most one subunit outside counts as lying on it. No end of the result is more than one subunit
  /// outside any edge. Nothing when the line is entirely outside.
  std::optional<Segment> clip(FinePoint a, FinePoint b) const;

 private:
  struct Side {
    Point outward;         // outward normal, as long as the edge
    std::int64_t support;  // dot(outward, p) for every point p on the edge
    std::int64_t subunit;  // growth of dot(outward, p) over one subunit beyond the edge, rounded down
  };
  struct Range;

  bool containsWithinSubunit(Point point) const;
  std::optional<Range> rangeInside(FinePoint a, FinePoint b, bool grown) const;
  Point nearestInside(Point point) const;

  std::vector<Side> sides_;
};

}  // namespace platon
