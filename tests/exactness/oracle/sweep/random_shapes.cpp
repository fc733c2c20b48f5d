#include "tests/exactness/oracle/sweep/random_shapes.h"

#include <cmath>
#include <numbers>

namespace platon::oracle {
namespace {

/// The hull of random points in a box: a polygon with few vertices.
Polygon randomHull(std::size_t points, std::int64_t scale, RandomSource& random) {
  Polygon hull;
  do {
    std::vector<Vec> cloud(points);
    const Vec centre = random.vector(scale / 2);
    const std::int64_t radius = random.oneIn(2) ? scale : random.between(1, scale);
    for (Vec& point : cloud) point = random.oneIn(3) ? centre + random.vector(radius / 2) : random.vector(radius);
    hull = convexHull(std::move(cloud));
  } while (!isStrictlyConvex(hull));
  return hull;
}

/// A polygon of `vertices` lattice points on an ellipse; fewer if rounding makes some collinear.
Polygon ellipse(std::size_t vertices, double width, double height, Vec centre) {
  std::vector<Vec> points(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
    points[i] = centre + Vec{std::llround(width * std::cos(angle)), std::llround(height * std::sin(angle))};
  }
  return convexHull(std::move(points));
}

Polygon manyVertices(std::int64_t scale, RandomSource& random) {
  const auto radius = [&] { return static_cast<double>(random.between(scale / 64 + 1, scale / 2 + 1)); };
  Polygon shape;
  while (!isStrictlyConvex(shape)) {
    const auto vertices = static_cast<std::size_t>(random.between(17, 64));
    shape = ellipse(vertices, radius(), radius(), random.vector(scale / 2));
  }
  return shape;
}

/// A triangle or quadrilateral up to `scale` long and about one subunit wide.
Polygon needle(std::int64_t scale, RandomSource& random) {
  Polygon hull;
  do {
    const Vec tip = random.vector(scale);
    const Vec end = random.oneIn(2) ? tip : -tip;
    hull = convexHull({tip, random.vector(1) - end, random.vector(1), tip + random.vector(1), random.vector(2) - end});
  } while (!isStrictlyConvex(hull));
  return hull;
}

Polygon box(std::int64_t scale, RandomSource& random) {
  const bool extreme = random.oneIn(2);
  const Vec low = extreme ? Vec{-scale, -scale} : Vec{random.between(-scale, 0), random.between(-scale, 0)};
  const Vec high =
      extreme && random.oneIn(2) ? Vec{scale, scale} : Vec{random.between(1, scale), random.between(1, scale)};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

}  // namespace

Polygon randomShape(ShapeKind kind, std::int64_t scale, RandomSource& random) {
  switch (kind) {
    case ShapeKind::Any:
      return randomHull(random.below(6) + 3, scale, random);
    case ShapeKind::ManyVertices:
      return manyVertices(scale, random);
    case ShapeKind::Ball:
      return ellipse(16, 12288, 12288, {});
    case ShapeKind::Needle:
      return needle(scale, random);
    case ShapeKind::Box:
      return box(scale, random);
  }
  return {};
}

Segment randomSegment(SegmentKind kind, const Polygon& shape, std::int64_t scale, RandomSource& random) {
  const std::size_t edge = random.below(shape.size());
  const Vec along = shape[(edge + 1) % shape.size()] - shape[edge];
  const Vec a = random.vector(random.oneIn(2) ? scale : scale / 4 + 1);
  const std::int64_t factor = random.oneIn(2) ? 1 : -random.between(1, 3);
  switch (kind) {
    case SegmentKind::Any:
      return {a, random.oneIn(16) ? a : random.vector(scale)};
    case SegmentKind::Point:
      return {a, a};
    case SegmentKind::Parallel:
      return {a, a + factor * along};
    case SegmentKind::EdgeCopy:
      return {a, random.oneIn(2) ? a + along : a - along};
    case SegmentKind::NearlyParallel:
      return {a, a + factor * along + random.vector(1)};
  }
  return {};
}

}  // namespace platon::oracle
