#include "platon/physics/obstacle.h"

#include <algorithm>

namespace platon {
namespace {

constexpr Box kEmptyBox{{1, 1}, {0, 0}};

// Margin of the box for which the relevant half planes are computed: a quarter of the shape's width. A larger margin
// means fewer recomputations, but more half planes per sweep. Measured.
std::int32_t relevantMargin(const Box& shape) { return (shape.high.x - shape.low.x) / 4; }

}  // namespace

std::array<Obstacle::HalfPlane, 2> Obstacle::sideHalfPlanes(const Convex& shape, const Segment& segment) {
  const Point left = perpendicular(segment.b - segment.a);
  std::int64_t lowest = dot(left, shape.vertices()[0]);
  std::int64_t highest = lowest;
  for (const Point vertex : shape.vertices()) {
    const std::int64_t height = dot(left, vertex);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const std::int64_t height = dot(left, segment.a);
  return {HalfPlane{left, lowest - height}, HalfPlane{-left, height - highest}};
}

Point Obstacle::sideFeature(const Convex& shape, Point normal) {
  Point feature = shape.vertices()[0];
  std::int64_t lowest = dot(normal, feature);
  for (const Point vertex : shape.vertices()) {
    const std::int64_t height = dot(normal, vertex);
    if (height < lowest) feature = vertex;
    lowest = std::min(lowest, height);
  }
  return feature;
}

void Obstacle::build(const Convex& shape, const Segment& segment) {
  shape_ = &shape;
  segment_ = segment;
  separatingHint_ = 0;
  relevantBox_ = kEmptyBox;
  groupSize_ = static_cast<std::uint32_t>((halfPlaneCount() + 63) / 64);
  if (sideCount() == 0) return;
  sides_ = sideHalfPlanes(shape, segment);
  for (std::size_t side = 0; side < 2; ++side) features_[side] = sideFeature(shape, sides_[side].normal);
}

// A half plane contains a box when it contains the corner farthest along its normal. Bounds: positions are within
// 2^29 + 2^12, so the box is within 2^30, and the distance below 2^62.
void Obstacle::findRelevant(const Box& positions) {
  relevantBox_ = positions.grown(relevantMargin(shape_->bounds()));
  relevantGroups_ = 0;
  const std::size_t count = halfPlaneCount();
  std::uint64_t group = 1;
  for (std::size_t i = 0; i < count; group <<= 1) {
    for (const std::size_t end = std::min(i + groupSize_, count); i < end; ++i) {
      const HalfPlane half = halfPlane(i);
      const Point farthest{half.normal.x > 0 ? relevantBox_.high.x : relevantBox_.low.x,
                           half.normal.y > 0 ? relevantBox_.high.y : relevantBox_.low.y};
      if (dot(half.normal, farthest) + half.offset >= 0) relevantGroups_ |= group;
    }
  }
}

}  // namespace platon
