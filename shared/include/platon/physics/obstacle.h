#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon {

/// The configuration-space obstacle of a segment L for a convex shape S (Lozano-Pérez, Spatial Planning: A
/// Configuration Space Approach, 1983): all positions at which S overlaps L. It is the open convex polygon L + (-S)
/// (docs/exactness.md), the intersection of half planes: the two sides of L, then one for each edge of -S. Its vertices
/// are not computed. Exact. Built once for a shape and a segment, then queried by many sweeps. Keeps the sides, and of
/// the others only which are relevant: an edge of the shape and two products give each again.
///
/// Bounds: with coordinates < 2^29, |normal| < 2^30, dot(normal, vertex) < 2^60 and |offset| < 2^61. With a segment
/// given relative to a position, whose coordinates are < 2^30, |offset| < 1.5 * 2^61.
class Obstacle {
 public:
  /// The positions p with dot(normal, p) + offset < 0. `normal` points out of the obstacle.
  struct HalfPlane {
    Point normal;
    std::int64_t offset;
    /// |normal.x| + |normal.y|, below 2^31.
    std::int32_t oneNorm() const { return std::abs(normal.x) + std::abs(normal.y); }
  };

  /// The half plane of an edge of the shape.
  static HalfPlane edgeHalfPlane(const Convex::Edge& edge, const Segment& segment) {
    return {edge.normal, edge.support - std::max(dot(edge.normal, segment.a), dot(edge.normal, segment.b))};
  }
  /// The half planes of the left and the right side of the segment. Requires segment.a != segment.b.
  static std::array<HalfPlane, 2> sideHalfPlanes(const Convex& shape, const Segment& segment);
  /// The vertex of the shape that reaches the line of a side with this normal first: the one with the smallest
  /// dot(normal, vertex), relative to the position. Of the two of a parallel edge, the first in the shape's order, even
  /// if it is beyond the end of the segment.
  static Point sideFeature(const Convex& shape, Point normal);

  /// An empty obstacle; call `build` before any query.
  Obstacle() = default;

  /// Computes the obstacle of `segment` for `shape`. The shape must outlive the obstacle's use.
  void build(const Convex& shape, const Segment& segment);
  /// Makes the obstacle empty.
  void reset() { shape_ = nullptr; }
  /// Whether the obstacle was built for this shape object.
  bool belongsTo(const Convex& shape) const { return shape_ == &shape; }

  const Convex& shape() const { return *shape_; }
  const Segment& segment() const { return segment_; }
  /// Half planes are numbered: the left and the right side of the segment (omitted for a point), then the edges of the
  /// shape.
  HalfPlane halfPlane(std::size_t index) const {
    const std::size_t sides = sideCount();
    return index < sides ? sides_[index] : edgeHalfPlane(shape_->edges()[index - sides], segment_);
  }
  std::size_t halfPlaneCount() const { return sideCount() + shape_->edges().size(); }
  /// 2, or 0 for a point.
  std::size_t sideCount() const { return segment_.a == segment_.b ? 0 : 2; }

  /// The half plane that excluded the last displacement. Tried first; influences speed only.
  HalfPlane separatingHalfPlane() const { return halfPlane(separatingHint_); }
  void setSeparatingHint(std::size_t index) { separatingHint_ = static_cast<std::uint32_t>(index); }

  /// Visits the indices, in ascending order, of all half planes that do not contain the whole box `positions`, until
  /// visit(index) returns false. Returns whether it never did. May visit others, and does so where a shape has more
  /// than 62 edges. What is relevant is cached for a larger box, so that consecutive steps of an entity do not
  /// recompute it.
  template <class Visit>
  bool visitRelevant(const Box& positions, Visit&& visit) {
    if (!relevantBox_.contains(positions)) findRelevant(positions);
    for (std::uint64_t groups = relevantGroups_; groups != 0; groups &= groups - 1) {
      std::size_t index = static_cast<std::size_t>(std::countr_zero(groups)) * groupSize_;
      const std::size_t end = groupSize_ == 1 ? index : std::min(index + groupSize_, halfPlaneCount()) - 1;
      do {
        if (!visit(index)) return false;
      } while (index++ != end);
    }
    return true;
  }
  /// As above, of side 0 or 1.
  Point sideFeature(std::size_t side) const { return features_[side]; }

 private:
  void findRelevant(const Box& positions);

  const Convex* shape_ = nullptr;
  Segment segment_;
  std::array<HalfPlane, 2> sides_{};
  std::array<Point, 2> features_;
  Box relevantBox_;
  std::uint64_t relevantGroups_ = 0;  // groups of successive half planes, a bit each
  std::uint32_t groupSize_ = 1;
  std::uint32_t separatingHint_ = 0;
};

}  // namespace platon
