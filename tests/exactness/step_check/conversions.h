#pragma once

#include <vector>

#include "platon/physics/segment.h"
#include "tests/exactness/oracle/exact_geometry.h"

/// Conversions between the types of the simulation and those of the oracle.
namespace platon::step_check {

inline oracle::Vec toVec(Point point) { return {point.x, point.y}; }

inline oracle::Segment toSegment(const Segment& line) { return {toVec(line.a), toVec(line.b)}; }

inline oracle::Polygon toPolygon(const std::vector<Point>& points) {
  oracle::Polygon polygon;
  for (const Point point : points) polygon.push_back(toVec(point));
  return polygon;
}

/// Every component of `v` is below 2^31 in magnitude.
inline Point toPoint(oracle::Vec v) { return {static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)}; }

inline Segment toSegment(const oracle::Segment& line) { return {toPoint(line.a), toPoint(line.b)}; }

inline std::vector<Point> toPoints(const oracle::Polygon& polygon) {
  std::vector<Point> points;
  for (const oracle::Vec v : polygon) points.push_back(toPoint(v));
  return points;
}

}  // namespace platon::step_check
