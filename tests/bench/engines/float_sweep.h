#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

template <class Real>
struct FloatVector {
  Real x = 0;
  Real y = 0;

  friend FloatVector operator+(FloatVector a, FloatVector b) { return {a.x + b.x, a.y + b.y}; }
  friend FloatVector operator-(FloatVector a, FloatVector b) { return {a.x - b.x, a.y - b.y}; }
  friend FloatVector operator*(FloatVector a, Real factor) { return {a.x * factor, a.y * factor}; }
  friend Real dot(FloatVector a, FloatVector b) { return a.x * b.x + a.y * b.y; }
  friend Real length(FloatVector a) { return std::sqrt(dot(a, a)); }
};

template <class Real>
FloatVector<Real> toFloat(Point point) {
  return {static_cast<Real>(point.x), static_cast<Real>(point.y)};
}

/// The edge of the obstacle that a sweep enters. `from` and `to` are its ends, as positions of the shape; the direction
/// from one to the other is the normal rotated a quarter turn counter-clockwise.
template <class Real>
struct FloatEdge {
  FloatVector<Real> normal;  ///< outward, of any length
  FloatVector<Real> from;
  FloatVector<Real> to;
};

/// A convex shape, prepared for sweeps.
template <class Real>
struct FloatShape {
  explicit FloatShape(const Convex& shape) {
    for (const Point vertex : shape.vertices()) vertices.push_back(toFloat<Real>(vertex));
    low = toFloat<Real>(shape.bounds().low);
    high = toFloat<Real>(shape.bounds().high);
    for (const Convex::Edge& edge : shape.edges()) {
      normals.push_back(toFloat<Real>(edge.normal));
      supports.push_back(static_cast<Real>(edge.support));
    }
  }

  std::vector<FloatVector<Real>> vertices;
  std::vector<FloatVector<Real>> normals;  ///< outward normals of the obstacle
  std::vector<Real> supports;
  FloatVector<Real> low;  ///< corners of the bounding box
  FloatVector<Real> high;
};

/// `Sweep` in floating point: clips the displacement against the half planes of the Minkowski sum of the segment and
/// the mirrored shape. The shape must outlive it.
template <class Real>
class FloatSweep {
 public:
  using Vector = FloatVector<Real>;

  FloatSweep(const FloatShape<Real>& shape, Vector position, Vector displacement)
      : shape_(shape), position_(position), displacement_(displacement) {
    const Vector end = position + displacement;
    low_ = {std::min(position.x, end.x) + shape.low.x, std::min(position.y, end.y) + shape.low.y};
    high_ = {std::max(position.x, end.x) + shape.high.x, std::max(position.y, end.y) + shape.high.y};
  }

  /// Time of the hit with the segment from a to b; 0 if the shape overlaps it at the start.
  std::optional<Real> against(Vector a, Vector b) {
    if (misses(a, b)) return std::nullopt;
    enter_ = 0;
    exit_ = 1;
    entered_ = false;
    if ((a.x != b.x || a.y != b.y) && !clipSides(a, b)) return std::nullopt;
    for (std::size_t i = 0; i < shape_.normals.size(); ++i) {
      const Vector normal = shape_.normals[i];
      const Real farther = std::max(dot(normal, a), dot(normal, b));
      if (!cut(dot(normal, position_) + shape_.supports[i] - farther, normal, i)) return std::nullopt;
    }
    if (!(enter_ < exit_)) return std::nullopt;
    return enter_;
  }
  /// The edge entered by the last hit, which was with the segment from a to b. For an overlap, the nearest edge.
  FloatEdge<Real> edge(Vector a, Vector b) const { return entered_ ? edgeAt(edge_, a, b) : nearest(a, b); }

 private:
  bool misses(Vector a, Vector b) const {
    return std::max(a.x, b.x) < low_.x || std::min(a.x, b.x) > high_.x || std::max(a.y, b.y) < low_.y ||
           std::min(a.y, b.y) > high_.y;
  }
  bool clipSides(Vector a, Vector b) {
    const Vector normal{a.y - b.y, b.x - a.x};
    Real low = dot(normal, shape_.vertices[0]);
    Real high = low;
    for (const Vector vertex : shape_.vertices) {
      low = std::min(low, dot(normal, vertex));
      high = std::max(high, dot(normal, vertex));
    }
    const Real height = dot(normal, position_ - a);
    const std::size_t count = shape_.vertices.size();
    return cut(height + low, normal, count) && cut(-height - high, normal * Real{-1}, count + 1);
  }

  bool cut(Real distance, Vector normal, std::size_t edge) {
    const Real speed = dot(normal, displacement_);
    if (distance >= 0) {
      if (distance >= -speed) return false;
      const Real time = distance / -speed;
      if (!entered_ || time > enter_) {
        enter_ = time;
        entered_ = true;
        edge_ = edge;
      }
      return true;
    }
    if (speed > -distance) exit_ = std::min(exit_, -distance / speed);
    return true;
  }

  Vector normalAt(std::size_t index, Vector a, Vector b) const {
    const Vector left{a.y - b.y, b.x - a.x};
    const std::size_t count = shape_.normals.size();
    return index < count ? shape_.normals[index] : left * static_cast<Real>(index == count ? 1 : -1);
  }
  // Edge `index` of the obstacle: its ends are differences of an end of the segment and a vertex of the shape.
  FloatEdge<Real> edgeAt(std::size_t index, Vector a, Vector b) const {
    const Vector normal = normalAt(index, a, b);
    const Vector tangent{-normal.y, normal.x};
    const auto along = [&](Vector u, Vector v) { return dot(tangent, u) < dot(tangent, v); };
    const auto [firstEnd, lastEnd] =
        std::minmax({dot(normal, a) < dot(normal, b) ? b : a, dot(normal, b) < dot(normal, a) ? a : b}, along);
    const auto [firstVertex, lastVertex] = touching(index, normal, along);
    return {normal, firstEnd - lastVertex, lastEnd - firstVertex};
  }
  template <class Along>
  std::pair<Vector, Vector> touching(std::size_t index, Vector normal, Along along) const {
    const auto& vertices = shape_.vertices;
    if (index < vertices.size()) return std::minmax({vertices[index], vertices[(index + 1) % vertices.size()]}, along);
    const auto less = [&](Vector u, Vector v) { return dot(normal, u) < dot(normal, v); };
    const Vector lowest = *std::min_element(vertices.begin(), vertices.end(), less);
    std::pair<Vector, Vector> ends{lowest, lowest};
    for (const Vector vertex : vertices) {
      if (!less(lowest, vertex)) ends = {std::min(ends.first, vertex, along), std::max(ends.second, vertex, along)};
    }
    return ends;
  }
  FloatEdge<Real> nearest(Vector a, Vector b) const {
    FloatEdge<Real> best;
    Real least = -std::numeric_limits<Real>::infinity();
    const bool isPoint = a.x == b.x && a.y == b.y;
    for (std::size_t i = 0; i < shape_.vertices.size() + (isPoint ? 0 : 2); ++i) {
      const FloatEdge<Real> edge = edgeAt(i, a, b);
      const Real distance = dot(edge.normal, position_ - edge.from) / length(edge.normal);
      if (distance <= least) continue;
      least = distance;
      best = edge;
    }
    return best;
  }

  const FloatShape<Real>& shape_;
  Vector position_;
  Vector displacement_;
  Vector low_;  // bounding box of the swept area
  Vector high_;
  Real enter_ = 0;
  Real exit_ = 1;
  bool entered_ = false;
  std::size_t edge_ = 0;  // index of a shape's edge; after those, the left and the right side of the segment
};

}  // namespace platon::bench
