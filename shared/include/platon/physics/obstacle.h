#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon {

/// All positions at which a shape S overlaps a line L (docs/exactness.md, the theorem): the open polygon L + (-S), as
/// the half planes that it is the intersection of. These belong to both sides of L and to the edges of -S; no vertex
/// of the polygon is computed. Made once for a shape and a line and asked many times. Nothing is rounded.
///
/// Bounds: coordinates < 2^29, so |normal| < 2^30, normal . vertex < 2^60 and |offset| < 2^61; of a line that is seen
/// from a position, whose coordinates are < 2^30, |offset| < 1.5 * 2^61.
class Obstacle {
 public:
  /// The positions with normal . position + offset < 0; `normal` points out of the obstacle.
  struct HalfPlane {
    Point normal;
    std::int64_t offset;
    /// What a step of one along both axes changes the distance by, at most. Below 2^31.
    std::int32_t slope() const { return std::abs(normal.x) + std::abs(normal.y); }
  };

  /// The half plane of an edge of the shape.
  static HalfPlane ofEdge(const Convex::Edge& edge, const Segment& line) {
    return {edge.normal, edge.support - std::max(dot(edge.normal, line.a), dot(edge.normal, line.b))};
  }
  /// Those of the left and of the right side of a line that is no point.
  static std::array<HalfPlane, 2> ofSides(const Convex& shape, const Segment& line);
  /// What touches where a side with this normal is entered: the first vertex of the shape, relative to its position,
  /// that lies farthest back along the normal.
  static Point featureOfSide(const Convex& shape, Point normal);

  /// Room for an obstacle: of no shape yet.
  Obstacle() = default;

  /// Becomes what `line` is to `shape`, which must live as long as it is asked.
  void become(const Convex& shape, const Segment& line);
  /// Is of no shape again; keeps its memory.
  void forget() { shape_ = nullptr; }
  bool isOf(const Convex& shape) const { return shape_ == &shape; }

  const Convex& shape() const { return *shape_; }
  const Segment& line() const { return line_; }
  /// First the left and the right side of the line, which a point does not have, then the edges of the shape.
  std::span<const HalfPlane> halfPlanes() const { return halfPlanes_; }
  std::size_t sides() const { return line_.a == line_.b ? 0 : 2; }

  /// A half plane that has shut out a whole way before, and is likely to do so again. No result depends on it.
  std::size_t separatingHint() const { return separatingHint_; }
  void setSeparatingHint(std::size_t halfPlane) { separatingHint_ = halfPlane; }

  /// The half planes, by ascending index, that positions within `way` may lie outside of: all others hold the whole
  /// box. They are few, and none deep inside; found for some way round the box and kept until one leads out of that.
  std::span<const std::uint32_t> boundariesNear(const Box& way) {
    if (!around_.contains(way)) findBoundaries(way);
    return boundaries_;
  }
  Point featureOfSide(std::size_t side) const { return features_[side]; }

 private:
  void findBoundaries(const Box& way);

  const Convex* shape_ = nullptr;
  Segment line_;
  std::vector<HalfPlane> halfPlanes_;
  std::array<Point, 2> features_;
  std::size_t separatingHint_ = 0;
  Box around_;
  std::vector<std::uint32_t> boundaries_;
};

}  // namespace platon
