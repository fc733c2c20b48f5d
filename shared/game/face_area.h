#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/physics/segment.h"

namespace platon {

/// A point as a level text gives it, not yet rounded, in 1/625 subunits: 0.0001 level units are 64 of them.
struct FinePoint {
  static constexpr std::int64_t kPerSubunit = 625;
  static constexpr std::int64_t kPerTenThousandth = 64;

  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// The area of a face, within which lines are cut. Exact: only the ends of a line are rounded, each once.
class FaceArea {
 public:
  /// Coordinates that `cut` takes are at most this many level units in magnitude: twice the largest face size.
  static constexpr std::int32_t kMaxUnits = 131072;

  /// A face polygon: convex, counter-clockwise, coordinates below 2^26.
  explicit FaceArea(std::span<const Point> polygon);

  /// True when the point is inside or on the edge.
  bool contains(Point point) const;

  /// The part of the line on the face, its ends rounded to subunits. An end that is no more than one subunit outside
  /// stays where it is; any other is cut at the edge, to the lattice point nearest to where the line meets the edge.
  /// A line that runs beside an edge no more than one subunit outside counts as lying on it. No end of the result is
  /// more than one subunit beyond any edge. Nothing when the line lies wholly outside.
  std::optional<Segment> cut(FinePoint a, FinePoint b) const;

 private:
  struct Side {
    Point outward;         // normal of the edge, as long as the edge
    std::int64_t support;  // outward . p of the points p on the edge
    std::int64_t subunit;  // what outward . p grows by within one subunit beyond the edge, rounded down
  };
  struct Range;

  bool reaches(Point point) const;
  std::optional<Range> clip(FinePoint a, FinePoint b, bool grown) const;
  Point settle(Point nearest) const;

  std::vector<Side> sides_;
};

}  // namespace platon
