#include "shared/physics/sweep.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace platon {
namespace {

std::int64_t growth(Point normal, std::int32_t grown) {
  return (std::abs(std::int64_t{normal.x}) + std::abs(std::int64_t{normal.y})) * grown;
}

constexpr std::size_t kLeftSide = ~std::size_t{0};
constexpr std::size_t kRightSide = kLeftSide - 1;
constexpr std::size_t kNoEdge = kLeftSide - 2;

}  // namespace

// The part of the displacement inside all half planes seen so far, each given as distance + t * speed < 0.
struct Sweep::Clip {
  Fraction enter{0, 1};
  Fraction exit{1, 1};
  std::size_t entered = kNoEdge;

  bool cut(std::int64_t distance, std::int64_t speed, std::size_t edge) {
    if (distance >= 0) {
      if (distance >= -speed) return false;  // outside for all of [0, 1)
      if (const Fraction time{distance, -speed}; entered == kNoEdge || time > enter) {
        enter = time;
        entered = edge;
      }
    } else if (speed > -distance) {  // leaves before the end
      if (const Fraction time{-distance, speed}; time < exit) exit = time;
    }
    return true;
  }
};

void Sweep::start(const Convex& shape, Point position, Point displacement, std::int32_t grown) {
  shape_ = &shape;
  position_ = position;
  displacement_ = displacement;
  grown_ = grown;
  const Box& box = shape.bounds();
  bounds_ = Box{box.low + position, box.high + position}.swept(displacement).grown(grown);
  edges_.clear();
}

void Sweep::prepareEdges() {
  for (const Convex::Edge& edge : shape_->edges()) {
    edges_.push_back({edge.normal, dot(edge.normal, position_) + edge.support - growth(edge.normal, grown_),
                      dot(edge.normal, displacement_)});
  }
}

std::optional<Hit> Sweep::against(const Segment& line) {
  if (!bounds_.overlaps(boundsOf(line)) || passes(line)) return std::nullopt;
  Clip clip;
  if (line.a != line.b && !clipSides(line, clip)) return std::nullopt;
  if (!clipEnds(line, clip)) return std::nullopt;
  if (!(clip.enter < clip.exit)) return std::nullopt;
  return describe(line, clip);
}

// Whether the line's own direction alone tells that even the bounding box of the shape misses it: most lines nearby.
bool Sweep::passes(const Segment& line) const {
  const Point normal = perpendicular(line.b - line.a);
  const Box& box = shape_->bounds();
  const auto along = [](std::int64_t factor, std::int32_t low, std::int32_t high) {
    return factor >= 0 ? Extent{factor * low, factor * high} : Extent{factor * high, factor * low};
  };
  const Extent x = along(normal.x, box.low.x, box.high.x);
  const Extent y = along(normal.y, box.low.y, box.high.y);
  Clip clip;
  return line.a != line.b && !clipSides(line, {x.low + y.low, x.high + y.high}, clip);
}

bool Sweep::clipSides(const Segment& line, Clip& clip) const {
  const Point normal = perpendicular(line.b - line.a);
  std::int64_t lowest = dot(normal, shape_->vertices()[0]);
  std::int64_t highest = lowest;
  for (const Point vertex : shape_->vertices()) {
    const std::int64_t along = dot(normal, vertex);
    lowest = std::min(lowest, along);
    highest = std::max(highest, along);
  }
  return clipSides(line, {lowest, highest}, clip);
}

// `extent` of the shape along the line's left normal, from its position.
bool Sweep::clipSides(const Segment& line, Extent extent, Clip& clip) const {
  const Point normal = perpendicular(line.b - line.a);
  const std::int64_t height = dot(normal, position_ - line.a);
  const std::int64_t margin = growth(normal, grown_);
  const std::int64_t speed = dot(normal, displacement_);
  return clip.cut(height + extent.low - margin, speed, kLeftSide) &&
         clip.cut(-height - extent.high - margin, -speed, kRightSide);
}

bool Sweep::clipEnds(const Segment& line, Clip& clip) {
  if (edges_.empty()) prepareEdges();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const MovingEdge& edge = edges_[i];
    const std::int64_t farther = std::max(dot(edge.normal, line.a), dot(edge.normal, line.b));
    if (!clip.cut(edge.distance - farther, edge.speed, i)) return false;
  }
  return true;
}

Hit Sweep::describe(const Segment& line, const Clip& clip) const {
  Hit hit{.time = clip.enter, .exit = clip.exit, .normal = {}, .feature = {}, .side = Hit::Side::kInside};
  if (clip.entered == kNoEdge) return hit;
  if (clip.entered == kLeftSide || clip.entered == kRightSide) {
    const Point left = perpendicular(line.b - line.a);
    hit.normal = clip.entered == kLeftSide ? left : -left;
    hit.side = Hit::Side::kLine;
    hit.feature = *std::min_element(
        shape_->vertices().begin(), shape_->vertices().end(),
        [&](Point a, Point b) { return dot(hit.normal, a) < dot(hit.normal, b); });
    return hit;
  }
  hit.normal = edges_[clip.entered].normal;
  const std::int64_t alongLine = dot(hit.normal, line.b - line.a);
  hit.side = alongLine == 0 && line.a != line.b ? Hit::Side::kLine : Hit::Side::kLineEnd;
  hit.feature = hit.side == Hit::Side::kLine ? shape_->vertices()[clip.entered]
                      : alongLine > 0              ? line.b
                                                   : line.a;
  return hit;
}

}  // namespace platon
