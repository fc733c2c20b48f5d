#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Exact plane geometry of the checkers. It shares no code with `shared/`, so that they cannot share an error.
namespace platon::oracle {

__extension__ using Wide = __int128;

/// Every input coordinate is below this in magnitude, so that the sum of two is below 2^31.
inline constexpr std::int64_t kCoordinateLimit = std::int64_t{1} << 29;

/// A lattice point or vector; each component below 2^32 in magnitude.
struct Vec {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const Vec&, const Vec&) = default;
  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator-(Vec a) { return {-a.x, -a.y}; }
  friend Vec operator*(std::int64_t k, Vec a) { return {k * a.x, k * a.y}; }
};

/// Twice the signed area of the triangle 0, a, b; exact for components below 2^63.
inline Wide cross(Vec a, Vec b) { return Wide{a.x} * b.y - Wide{a.y} * b.x; }

inline Wide dot(Vec a, Vec b) { return Wide{a.x} * b.x + Wide{a.y} * b.y; }

inline int sign(Wide value) { return (value > 0) - (value < 0); }

/// A closed segment. It is a point if both ends are equal.
struct Segment {
  Vec a;
  Vec b;

  friend bool operator==(const Segment&, const Segment&) = default;
};

using Polygon = std::vector<Vec>;

/// True if the polygon turns left at every vertex and winds around exactly once.
bool isStrictlyConvex(const Polygon& polygon);

/// The strictly convex hull, counter-clockwise (Andrew's monotone chain). It has fewer than three vertices if all
/// points are collinear.
Polygon convexHull(std::vector<Vec> points);

/// An axis-aligned bounding box, edges included.
struct Box {
  Vec low;
  Vec high;

  /// True if the closed boxes have a common point.
  bool touches(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
  Box grown(std::int64_t by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
  Box moved(Vec by) const { return {low + by, high + by}; }
  Box joined(const Box& other) const;
};

Box boxOf(const Polygon& polygon);
Box boxOf(const Segment& segment);

/// The four coordinates, for messages.
std::string toText(const Segment& segment);

/// The open half plane of all points q with dot(outward, q) < bound.
struct HalfPlane {
  Vec outward;
  Wide bound = 0;
};

/// An open convex area: the intersection of open half planes. Coordinates and normals are below 2^31 in magnitude.
class OpenArea {
 public:
  /// The open interior of `shape` (strictly convex, counter-clockwise) at `position`.
  static OpenArea placed(const Polygon& shape, Vec position);
  /// The area that the open interior of `shape` covers on its straight path from `from` to `from` + `displacement`: the
  /// open convex hull of both placements.
  static OpenArea swept(const Polygon& shape, Vec from, Vec displacement);

  /// The area with every side moved inwards by `distance` subunits, outwards if `distance` is negative. Meant for
  /// tolerances: unlike everything else here it is inexact, by less than one subunit.
  OpenArea inset(std::int64_t distance) const;

  /// True if the closed segment has a point in the area. Exact.
  bool intersects(const Segment& segment) const;

 private:
  std::vector<HalfPlane> sides_;
};

}  // namespace platon::oracle
