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

/// The vertices of a shape, which a program may add one by one. They are checked when a Convex or an Entity is made of
/// them. The name is that of the program with which this engine began, so that code written for it compiles.
struct Convex {
  std::vector<Point> vertices;
};

}  // namespace intern

/// An immutable, strictly convex polygon with vertices in counter-clockwise order. Its interior is open: touching a
/// segment is not an overlap.
class Convex {
 public:
  /// An edge of the polygon. Every obstacle of the polygon has an edge parallel to it (docs/exactness.md); `normal` is
  /// the outward normal of that obstacle edge, so it points into the polygon.
  struct Edge {
    Point normal;
    std::int64_t support;  ///< dot(normal, vertex), equal for both ends of the edge
  };

  /// Checks that `vertices` form a strictly convex, counter-clockwise polygon with coordinates below 2^29. Returns the
  /// first fault as an English sentence, which counts vertices from 1, or nothing when there is none. Do not repeat the
  /// first vertex at the end.
  static std::optional<std::string> fault(std::span<const Point> vertices);

  /// Throws std::invalid_argument with the text of fault() when `vertices` are not valid.
  explicit Convex(std::vector<Point> vertices);
  explicit Convex(const intern::Convex& draft) : Convex(draft.vertices) {}

  const std::vector<Point>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const Box& bounds() const { return bounds_; }
  /// A point of the shape: the mean of the vertices, rounded. `turned` rotates it as it rotates the vertices. An
  /// entity's home part is the map part that contains this point.
  Point centre() const { return centre_; }

  /// The convex hull of the vertices rotated by `angle` about the origin and rounded to the lattice; the shape itself
  /// for angle 0. Rounding can make vertices collinear or equal; the hull then has fewer vertices. Its centre is not
  /// their mean, but this shape's centre, rotated and rounded: along each axis within 1/2 + |centre| * 2^-28 subunits
  /// of the exact image of this shape's centre, where |centre| is the larger of its coordinates. Returns nothing when
  /// the result is degenerate (possible for shapes of a few subunits) or out of range.
  std::optional<Convex> turned(Angle angle) const;

  friend bool operator==(const Convex& a, const Convex& b) {
    return a.vertices_ == b.vertices_ && a.centre_ == b.centre_;
  }

 private:
  friend class ShapeCache;

  // As `turned`, into another shape, whose memory is reused. Returns false, and leaves `result` unusable, when the
  // rotated shape is degenerate, out of range or has fewer vertices than this one.
  bool turnInto(Convex& result, Angle angle) const;
  // Makes this shape the convex hull of two others. Reuses its memory and that of `work`.
  void becomeHull(const Convex& a, const Convex& b, std::vector<Point>& work);
  void deriveFromVertices();

  std::vector<Point> vertices_;
  std::vector<Edge> edges_;
  Box bounds_;
  Point centre_;
};

/// The convex hull of `points` by monotone chains (Andrew 1979): strictly convex, counter-clockwise, starting with the
/// hull vertex that comes first in `points`. Fewer than three vertices when all points are collinear.
std::vector<Point> convexHull(std::vector<Point> points);

}  // namespace platon
