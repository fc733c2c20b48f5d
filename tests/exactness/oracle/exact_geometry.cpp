#include "tests/exactness/oracle/exact_geometry.h"

#include <algorithm>
#include <cmath>

namespace platon::oracle {
namespace {

/// 0 for directions from 0° to below 180°, 1 for the others.
int half(Vec v) { return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1; }

void addToChain(Polygon& chain, std::size_t fixed, Vec point) {
  while (chain.size() >= fixed + 2) {
    const Vec last = chain[chain.size() - 1];
    if (cross(last - chain[chain.size() - 2], point - last) > 0) break;
    chain.pop_back();
  }
  chain.push_back(point);
}

Wide supportOf(const Polygon& shape, Vec direction) {
  Wide best = dot(direction, shape.front());
  for (const Vec vertex : shape) best = std::max(best, dot(direction, vertex));
  return best;
}

/// distance * |v|, rounded up.
Wide timesLength(std::int64_t distance, Vec v) {
  const long double length = std::hypot(static_cast<long double>(v.x), static_cast<long double>(v.y));
  return static_cast<Wide>(std::ceil(static_cast<long double>(distance) * length));
}

}  // namespace

bool isStrictlyConvex(const Polygon& polygon) {
  if (polygon.size() < 3) return false;
  int wraps = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec here = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Vec next = polygon[(i + 2) % polygon.size()] - polygon[(i + 1) % polygon.size()];
    if (cross(here, next) <= 0) return false;
    wraps += half(here) == 1 && half(next) == 0;
  }
  return wraps == 1;
}

Polygon convexHull(std::vector<Vec> points) {
  const auto before = [](Vec a, Vec b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  for (const Vec point : points) addToChain(hull, 0, point);
  const std::size_t lower = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) addToChain(hull, lower, *point);
  hull.pop_back();
  return hull;
}

Box Box::joined(const Box& other) const {
  return {{std::min(low.x, other.low.x), std::min(low.y, other.low.y)},
          {std::max(high.x, other.high.x), std::max(high.y, other.high.y)}};
}

Box boxOf(const Polygon& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vec vertex : polygon) box = box.joined({vertex, vertex});
  return box;
}

Box boxOf(const Segment& segment) { return Box{segment.a, segment.a}.joined({segment.b, segment.b}); }

std::string toText(const Segment& segment) {
  return std::to_string(segment.a.x) + " " + std::to_string(segment.a.y) + " " + std::to_string(segment.b.x) + " " +
         std::to_string(segment.b.y);
}

OpenArea OpenArea::placed(const Polygon& shape, Vec position) { return swept(shape, position, {0, 0}); }

OpenArea OpenArea::swept(const Polygon& shape, Vec from, Vec displacement) {
  OpenArea area;
  area.sides_.reserve(shape.size() + 2);
  const auto add = [&](Vec outward, Wide support) {
    area.sides_.push_back({outward, support + dot(outward, from) + std::max<Wide>(0, dot(outward, displacement))});
  };
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec edge = shape[(i + 1) % shape.size()] - shape[i];
    const Vec outward{edge.y, -edge.x};
    add(outward, dot(outward, shape[i]));
  }
  if (displacement == Vec{}) return area;
  const Vec left{-displacement.y, displacement.x};
  add(left, supportOf(shape, left));
  add(-left, supportOf(shape, -left));
  return area;
}

OpenArea OpenArea::inset(std::int64_t distance) const {
  OpenArea area = *this;
  for (HalfPlane& side : area.sides_) side.bound -= timesLength(distance, side.outward);
  return area;
}

bool OpenArea::intersects(const Segment& segment) const {
  // The point a + u(b - a) is inside a side if depthA + u(depthB - depthA) > 0. The bounds of u are fractions with
  // positive denominators. |depth| < 2^64; |denominator| < 2^63, because the components of normals and of b - a are
  // below 2^31. Hence every product fits.
  Wide lowNumerator = 0;
  Wide lowDenominator = 1;
  Wide highNumerator = 1;
  Wide highDenominator = 1;
  bool lowIsOpen = false;
  for (const HalfPlane& side : sides_) {
    const Wide depthA = side.bound - dot(side.outward, segment.a);
    const Wide depthB = side.bound - dot(side.outward, segment.b);
    if (depthA <= 0 && depthB <= 0) return false;
    if (depthA > 0 && depthB > 0) continue;
    if (depthA <= 0) {
      const Wide denominator = depthB - depthA;
      if (-depthA * lowDenominator >= lowNumerator * denominator) {
        lowNumerator = -depthA;
        lowDenominator = denominator;
        lowIsOpen = true;
      }
    } else if (const Wide denominator = depthA - depthB; depthA * highDenominator < highNumerator * denominator) {
      highNumerator = depthA;
      highDenominator = denominator;
    }
  }
  return !lowIsOpen || lowNumerator * highDenominator < highNumerator * lowDenominator;
}

}  // namespace platon::oracle
