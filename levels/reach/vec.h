#pragma once

#include <algorithm>
#include <cmath>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A point or vector in level units.
struct Vec {
  double x = 0;
  double y = 0;

  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(Vec a, double factor) { return {a.x * factor, a.y * factor}; }
};

inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::hypot(a.x, a.y); }

/// `point` rotated by -`up`: in a frame in which up is +y.
inline Vec uprightOf(Point point, Angle up) {
  const Point turned = rotate(point, -up);
  return {double{1} * turned.x / kSubunitsPerUnit, double{1} * turned.y / kSubunitsPerUnit};
}

/// A straight line between two points; equal ends make a point.
struct Line {
  Vec a;
  Vec b;
};

/// An axis-aligned rectangle.
struct Rect {
  Vec low;
  Vec high;

  Vec middle() const { return (low + high) * 0.5; }
};

/// The bounding box of a line, larger by `margin` on every side.
Rect boundsOf(const Line& line, Vec margin);
/// Distance of a point from a line.
double distance(Vec point, const Line& line);
/// Distance of a rectangle from a line; 0 when they touch.
double distance(const Rect& rect, const Line& line);

}  // namespace platon
