#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/segment.h"

namespace platon {

namespace intern {

/// The draft of a shape: vertices are pushed one by one and checked when an entity is made of it.
struct Convex {
  std::vector<Point> vertices;
};

}  // namespace intern

/// A strictly convex polygon in counter-clockwise order, immutable. Its interior is open: touching is no overlap.
class Convex {
 public:
  /// An edge of the polygon as an edge of every obstacle that the polygon makes of a line (docs/exactness.md, the
  /// theorem): `normal` points out of the obstacle, that is into the polygon.
  struct Edge {
    Point normal;
    std::int64_t support;  ///< normal . vertex, the same at both ends of the edge
  };

  /// Why `vertices` is no strictly convex counter-clockwise polygon of coordinates below 2^29; nothing when it is.
  static std::optional<std::string> fault(std::span<const Point> vertices);

  /// Throws std::invalid_argument with the fault.
  explicit Convex(std::vector<Point> vertices);
  explicit Convex(const intern::Convex& draft) : Convex(draft.vertices) {}

  const std::vector<Point>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const Box& bounds() const { return bounds_; }
  /// The mean of the vertices, rounded: the point that decides which map part an entity is at home in.
  Point centre() const { return centre_; }

  /// The smallest convex polygon round the vertices turned by `angle` and rounded; turning by nothing gives the same
  /// vertices. A shape of a few subunits can degenerate when rounded; then there is none.
  std::optional<Convex> turned(Angle angle) const;

  friend bool operator==(const Convex& a, const Convex& b) { return a.vertices_ == b.vertices_; }

 private:
  std::vector<Point> vertices_;
  std::vector<Edge> edges_;
  Box bounds_;
  Point centre_;
};

/// The convex hull, strictly convex and counter-clockwise, beginning with the vertex that comes first in `points`.
/// Fewer than three vertices when the points lie on one line.
std::vector<Point> convexHull(std::vector<Point> points);

}  // namespace platon
