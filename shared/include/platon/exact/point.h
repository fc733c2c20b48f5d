#pragma once

#include <cstdint>

namespace platon {

/// A position or displacement in subunits. Coordinates handed to the simulation are below 2^29 in magnitude, so that
/// sums and differences of two fit `int32` and their products fit `int64`.
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

/// Inner product. Exact: |a|, |b| < 2^31 a coordinate give less than 2^63.
constexpr std::int64_t dot(Point a, Point b) { return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y; }

/// Cross product, positive when b lies counter-clockwise of a. Exact like `dot`.
constexpr std::int64_t cross(Point a, Point b) { return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x; }

/// Squared length.
constexpr std::int64_t squaredLength(Point a) { return dot(a, a); }

/// The vector turned a quarter counter-clockwise.
constexpr Point perpendicular(Point a) { return {-a.y, a.x}; }

}  // namespace platon
