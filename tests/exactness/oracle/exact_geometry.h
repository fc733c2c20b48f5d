#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The checkers' own exact plane geometry. Nothing here comes from `shared/`: an error there must not be repeated by
/// what checks it.
namespace platon::oracle {

__extension__ using Wide = __int128;

/// Coordinates that enter from outside are smaller than this in magnitude; sums of two of them stay below 2^31.
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

/// A closed segment; both ends equal = a point.
struct Segment {
  Vec a;
  Vec b;

  friend bool operator==(const Segment&, const Segment&) = default;
};

using Polygon = std::vector<Vec>;

/// True when the vertices turn strictly left everywhere and go round exactly once.
bool isStrictlyConvex(const Polygon& polygon);

/// The strictly convex hull, counter-clockwise (Andrew's monotone chain). Fewer than three vertices come back when
/// all points are collinear.
Polygon convexHull(std::vector<Vec> points);

/// Smallest box around something, edges included.
struct Box {
  Vec low;
  Vec high;

  /// True when the interiors of the boxes, each grown to at least one point, may meet a common point.
  bool touches(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
  Box grown(std::int64_t by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
  Box moved(Vec by) const { return {low + by, high + by}; }
  Box joined(const Box& other) const;
};

Box boxOf(const Polygon& polygon);
Box boxOf(const Segment& segment);

/// For messages: the four numbers.
std::string toText(const Segment& segment);

/// The open set of all points q with dot(outward, q) < bound.
struct HalfPlane {
  Vec outward;
  Wide bound = 0;
};

/// An open convex area as an intersection of open half-planes. Coordinates below 2^31, normals below 2^31.
class OpenArea {
 public:
  /// The open interior of `shape` (strictly convex, counter-clockwise) standing at `position`.
  static OpenArea standing(const Polygon& shape, Vec position);
  /// Every point that the open interior of `shape` covers while going straight from `from` to `from` + `displacement`,
  /// which is the open convex hull of its first and its last placement.
  static OpenArea swept(const Polygon& shape, Vec from, Vec displacement);

  /// The same area with every side moved inwards by `distance` subunits (outwards where it is negative), give or take
  /// less than one subunit: the only measure here that is not exact, meant for tolerances.
  OpenArea inset(std::int64_t distance) const;

  /// True when the closed segment has a point in the area. Exact.
  bool meets(const Segment& segment) const;

 private:
  std::vector<HalfPlane> sides_;
};

}  // namespace platon::oracle
