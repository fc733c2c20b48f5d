#include "platon/physics/obstacle.h"

#include <algorithm>

namespace platon {
namespace {

constexpr Box kEmpty{{1, 1}, {0, 0}};

// The wider the surroundings, the longer the boundaries in them serve, but the more of them there are. Measured.
std::int32_t surroundings(const Box& shape) { return (shape.high.x - shape.low.x) / 4; }

}  // namespace

std::array<Obstacle::HalfPlane, 2> Obstacle::ofSides(const Convex& shape, const Segment& line) {
  const Point left = perpendicular(line.b - line.a);
  std::int64_t lowest = dot(left, shape.vertices()[0]);
  std::int64_t highest = lowest;
  for (const Point vertex : shape.vertices()) {
    const std::int64_t along = dot(left, vertex);
    lowest = std::min(lowest, along);
    highest = std::max(highest, along);
  }
  const std::int64_t height = dot(left, line.a);
  return {HalfPlane{left, lowest - height}, HalfPlane{-left, height - highest}};
}

Point Obstacle::featureOfSide(const Convex& shape, Point normal) {
  Point feature = shape.vertices()[0];
  std::int64_t lowest = dot(normal, feature);
  for (const Point vertex : shape.vertices()) {
    const std::int64_t along = dot(normal, vertex);
    if (along < lowest) feature = vertex;
    lowest = std::min(lowest, along);
  }
  return feature;
}

void Obstacle::become(const Convex& shape, const Segment& line) {
  shape_ = &shape;
  line_ = line;
  separatingHint_ = 0;
  around_ = kEmpty;
  halfPlanes_.clear();
  halfPlanes_.reserve(shape.edges().size() + 2);
  boundaries_.reserve(shape.edges().size() + 2);
  if (sides() != 0) {
    for (const HalfPlane& side : ofSides(shape, line)) {
      features_[halfPlanes_.size()] = featureOfSide(shape, side.normal);
      halfPlanes_.push_back(side);
    }
  }
  for (const Convex::Edge& edge : shape.edges()) halfPlanes_.push_back(ofEdge(edge, line));
}

// A half plane holds a box when it holds the corner that lies farthest out. Bounds: the box lies within 2^30 + 2^28,
// so that the distance is below 2^63.
void Obstacle::findBoundaries(const Box& way) {
  around_ = way.grown(surroundings(shape_->bounds()));
  boundaries_.clear();
  for (std::uint32_t i = 0; i < halfPlanes_.size(); ++i) {
    const HalfPlane& half = halfPlanes_[i];
    const Point farthest{half.normal.x > 0 ? around_.high.x : around_.low.x,
                         half.normal.y > 0 ? around_.high.y : around_.low.y};
    if (dot(half.normal, farthest) + half.offset >= 0) boundaries_.push_back(i);
  }
}

}  // namespace platon
