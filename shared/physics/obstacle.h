#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "shared/physics/convex.h"
#include "shared/physics/segment.h"

namespace platon {

/// All positions at which a shape S overlaps a line L (docs/exactness.md, the theorem): the open polygon L + (-S), as
/// the half planes that it is the intersection of. These belong to both sides of L and to the edges of -S; no vertex
/// of the polygon is computed. Made once for a shape and a line and asked many times. Nothing is rounded.
///
/// Bounds: coordinates < 2^29, so |normal| < 2^30, normal . vertex < 2^60 and |offset| < 2^61.
class Obstacle {
 public:
  /// The positions with normal . position + offset < 0; `normal` points out of the obstacle.
  struct HalfPlane {
    HalfPlane(Point n, std::int64_t o) : normal(n), slope(std::abs(n.x) + std::abs(n.y)), offset(o) {}

    Point normal;
    std::int32_t slope;    ///< |nx| + |ny| < 2^31: what a step of one along both axes changes the distance by, at most
    std::int64_t offset;
  };

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
  std::size_t likelyBarrier() const { return likelyBarrier_; }
  void expectBarrier(std::size_t halfPlane) { likelyBarrier_ = halfPlane; }

  /// The half planes, by ascending index, that positions within `way` may lie outside of: all others hold the whole
  /// box. They are few, and none deep inside; found for some way round the box and kept until one leads out of that.
  std::span<const std::uint32_t> boundariesNear(const Box& way) {
    if (!around_.contains(way)) findBoundaries(way);
    return boundaries_;
  }
  /// What touches where one of the sides has been entered: the first vertex of the shape, relative to its position,
  /// that lies farthest back along the normal.
  Point featureOfSide(std::size_t side) const { return features_[side]; }

 private:
  void addSides();
  void findBoundaries(const Box& way);

  const Convex* shape_ = nullptr;
  Segment line_;
  std::vector<HalfPlane> halfPlanes_;
  std::array<Point, 2> features_;
  std::size_t likelyBarrier_ = 0;
  Box around_;
  std::vector<std::uint32_t> boundaries_;
};

}  // namespace platon
