#include "tests/bench/overlap.h"

#include <algorithm>
#include <limits>

#include "tests/bench/engines/float_sweep.h"

namespace platon::bench {

// long double has 64 bits of mantissa, which is exact for lattice points. The sides of the obstacle are those of the
// segment and of the shape.
long double separationOf(const Convex& shape, long double x, long double y, const Segment& line) {
  using Vector = FloatVector<long double>;
  const Vector position{x, y};
  const Vector a = toFloat<long double>(line.a);
  const Vector b = toFloat<long double>(line.b);
  long double farthestOut = -std::numeric_limits<long double>::infinity();
  const auto side = [&](Vector normal, long double distance) {
    farthestOut = std::max(farthestOut, distance / length(normal));
  };
  for (const Convex::Edge& edge : shape.edges()) {
    const Vector normal = toFloat<long double>(edge.normal);
    side(normal,
         dot(normal, position) + static_cast<long double>(edge.support) - std::max(dot(normal, a), dot(normal, b)));
  }
  if (line.a == line.b) return farthestOut;
  const Vector left{a.y - b.y, b.x - a.x};
  const auto [low, high] = std::minmax_element(shape.vertices().begin(), shape.vertices().end(), [&](Point u, Point v) {
    return dot(left, toFloat<long double>(u)) < dot(left, toFloat<long double>(v));
  });
  const long double height = dot(left, position - a);
  side(left, height + dot(left, toFloat<long double>(*low)));
  side(left, -height - dot(left, toFloat<long double>(*high)));
  return farthestOut;
}

double overlapOf(const Convex& shape, long double x, long double y, const Segment& line) {
  return static_cast<double>(std::max(0.0L, -separationOf(shape, x, y, line)));
}

}  // namespace platon::bench
