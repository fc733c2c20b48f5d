#pragma once

#include <algorithm>
#include <cstdint>

namespace platon {

/// A position or displacement in subunits. Coordinates of the simulation are below 2^29 in magnitude, so the sum or
/// difference of two fits `int32` and a product of two such sums fits `int64`.
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;

  constexpr Point() = default;
  constexpr Point(std::int32_t px, std::int32_t py) : x(px), y(py) {}

  friend constexpr bool operator==(const Point&, const Point&) = default;
  constexpr Point& operator+=(Point other) { return *this = Point(x + other.x, y + other.y); }
  constexpr Point& operator-=(Point other) { return *this = Point(x - other.x, y - other.y); }
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator-(Point a) { return {-a.x, -a.y}; }

/// Dot product. Exact when all coordinates are below 2^31 in magnitude (the result is below 2^63).
constexpr std::int64_t dot(Point a, Point b) { return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y; }

/// Cross product; positive when `b` is counter-clockwise of `a`. Exact for the same range as `dot`.
constexpr std::int64_t cross(Point a, Point b) { return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x; }

/// Squared length.
constexpr std::int64_t squaredLength(Point a) { return dot(a, a); }

/// The larger of |x| and |y|.
constexpr std::int32_t maxNorm(Point a) { return std::max(a.x < 0 ? -a.x : a.x, a.y < 0 ? -a.y : a.y); }

/// `a` rotated by 90° counter-clockwise.
constexpr Point perpendicular(Point a) { return {-a.y, a.x}; }

}  // namespace platon
