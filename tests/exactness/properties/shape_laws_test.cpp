// Laws of shapes, slides and grids.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/convex.h"
#include "platon/physics/grid.h"
#include "shared/physics/ideal_geometry.h"
#include "tests/exactness/oracle/sweep/random_shapes.h"
#include "tests/exactness/properties/lattice_map.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::shape_laws_test {
namespace {

using oracle::RandomSource;
using step_check::toPoint;
using step_check::toPoints;
using step_check::toVec;

// Strictly convex polygons, and some that just fail to be: with a moved, swapped or repeated vertex, or wound twice.
std::vector<Point> anyPolygon(RandomSource& random) {
  const std::int64_t scale = std::int64_t{1} << random.between(1, 24);
  std::vector<Point> polygon =
      toPoints(oracle::randomShape(random.oneIn(2) ? oracle::ShapeKind::Any : oracle::ShapeKind::Ball, scale, random));
  Point& vertex = polygon[random.below(polygon.size())];
  switch (random.below(6)) {
    case 0:
      vertex += toPoint(random.vector(2));
      break;
    case 1:
      std::swap(vertex, polygon[random.below(polygon.size())]);
      break;
    case 2:
      vertex = polygon[random.below(polygon.size())];
      break;
    case 3:
      std::reverse(polygon.begin(), polygon.end());
      break;
    case 4:
      polygon.insert(polygon.end(), polygon.begin(), polygon.end());
      break;
    default:
      break;
  }
  return polygon;
}

TEST(ShapeLawsTest, ConvexityDoesNotDependOnPlaceRotationOrFirstVertex) {
  std::int64_t faults = 0;
  const std::int64_t cases = repetitions(100000);
  forEachCase(cases, [&](RandomSource& random) {
    const std::vector<Point> polygon = anyPolygon(random);
    const bool faulty = Convex::fault(polygon).has_value();
    faults += faulty ? 1 : 0;
    EXPECT_EQ(faulty, !oracle::isStrictlyConvex(step_check::toPolygon(polygon)));
    const LatticeMap map = anyMap(random, 1 << 27);
    std::vector<Point> mapped = map.shape(polygon);
    for (Point& vertex : mapped) vertex += map.shift;
    std::rotate(mapped.begin(), mapped.begin() + random.between(0, static_cast<std::int64_t>(mapped.size()) - 1),
                mapped.end());
    EXPECT_EQ(Convex::fault(mapped).has_value(), faulty);
  });
  EXPECT_GT(faults, cases / 10);
  EXPECT_LT(faults, cases * 9 / 10);
}

// Random points; half of the time in a small box, so that some are equal or collinear.
std::vector<Point> anyCloud(RandomSource& random) {
  const std::int64_t radius = random.oneIn(2) ? random.between(0, 4) : std::int64_t{1} << random.between(1, 28);
  std::vector<Point> cloud(random.below(40) + 1);
  for (Point& point : cloud) point = toPoint(random.vector(radius));
  return cloud;
}

std::set<std::pair<std::int32_t, std::int32_t>> asSet(const std::vector<Point>& points) {
  std::set<std::pair<std::int32_t, std::int32_t>> set;
  for (const Point point : points) set.insert({point.x, point.y});
  return set;
}

TEST(ShapeLawsTest, TheHullOfAHullIsItself) {
  forEachCase(repetitions(50000), [](RandomSource& random) {
    std::vector<Point> cloud = anyCloud(random);
    const std::vector<Point> hull = convexHull(cloud);
    const bool flat = Convex::fault(hull).has_value();
    EXPECT_EQ(flat, hull.size() < 3);
    EXPECT_EQ(asSet(convexHull(hull)), asSet(hull));
    if (!flat) {
      EXPECT_EQ(convexHull(hull), hull) << "starts at another vertex";
    }
    for (std::size_t i = 0; i < hull.size() && !flat; ++i) {
      const Point along = hull[(i + 1) % hull.size()] - hull[i];
      for (const Point point : cloud) EXPECT_GE(cross(along, point - hull[i]), 0) << "a point outside";
    }
    cloud.insert(cloud.end(), cloud.begin(), cloud.end());
    std::reverse(cloud.begin(), cloud.end());
    if (flat) return;
    EXPECT_EQ(asSet(convexHull(cloud)), asSet(hull)) << "depends on order or repetition";
    const LatticeMap map = anyMap(random, 0);
    EXPECT_EQ(asSet(convexHull(map.shape(cloud))), asSet(map.shape(hull)));
  });
}

// Quarter turns and mirroring are exact.
PrecisePoint preciselyMapped(const LatticeMap& map, PrecisePoint p) {
  const Point x = map.vector({1, 0});
  const Point y = map.vector({0, 1});
  return {x.x * p.x + y.x * p.y, x.y * p.x + y.y * p.y};
}

Point anyVector(RandomSource& random, std::int64_t limit) {
  Point vector;
  while (vector == Point())
    vector = {static_cast<std::int32_t>(anyInteger(random, limit)),
              static_cast<std::int32_t>(anyInteger(random, limit))};
  return vector;
}

TEST(ShapeLawsTest, AnIdealSlideLeadsAlongTheEdgeAndIsSymmetric) {
  forEachCase(repetitions(500000), [&](RandomSource& random) {
    const Point normal = anyVector(random, (std::int64_t{1} << 29) - 1);
    const PrecisePoint displacement = precise(anyVector(random, (std::int64_t{1} << 29) - 1));
    const PrecisePoint slid = alongEdge(normal, displacement);
    const Obstacle::HalfPlane half{normal, 0};
    const int128 outwards = distanceTo(half, slid);
    EXPECT_TRUE(2 * outwards <= half.oneNorm() && -2 * outwards <= half.oneNorm()) << "off the edge";
    const LatticeMap map = anyMap(random, 0);
    const auto mapped = [&](PrecisePoint p) { return preciselyMapped(map, p); };
    EXPECT_EQ(alongEdge(map.vector(normal), mapped(displacement)), mapped(slid));
  });
}

// Exact: true if neither an axis nor the normal of the segment separates them.
bool overlaps(const Segment& line, const Box& box) {
  if (!boundsOf(line).overlaps(box)) return false;
  const auto side = [&](std::int32_t x, std::int32_t y) {
    return oracle::sign(oracle::cross(toVec(line.b) - toVec(line.a), oracle::Vec{x, y} - toVec(line.a)));
  };
  const int sum = side(box.low.x, box.low.y) + side(box.high.x, box.low.y) + side(box.high.x, box.high.y) +
                  side(box.low.x, box.high.y);
  return std::abs(sum) != 4;
}

std::vector<Segment> anyLines(RandomSource& random, std::int64_t radius) {
  std::vector<Segment> lines(random.below(80));
  const Point knot = toPoint(random.vector(radius));
  for (Segment& line : lines) {
    const Point a = toPoint(random.vector(radius));
    const Point b = toPoint(random.vector(radius));
    switch (random.below(6)) {
      case 0:
        line = {a, a};
        break;
      case 1:
        line = {a, {b.x, a.y}};
        break;
      case 2:
        line = {{knot.x, a.y}, {knot.x, b.y}};
        break;
      case 3:
        line = {knot, b};
        break;
      case 4:
        line = {knot, knot};
        break;
      default:
        line = {a, b};
    }
  }
  return lines;
}

TEST(ShapeLawsTest, AGridFindsEverySegmentThatOverlapsABox) {
  std::int64_t found = 0;
  forEachCase(repetitions(20000), [&](RandomSource& random) {
    const std::int64_t radius =
        random.oneIn(4) ? platon::kCoordinateLimit - 1 : (std::int64_t{1} << random.between(1, 29)) - 1;
    const std::vector<Segment> lines = anyLines(random, radius);
    const Grid grid(lines);
    for (int query = 0; query < 12; ++query) {
      const Segment diagonal{toPoint(random.vector(radius)),
                             toPoint(random.vector(random.oneIn(2) ? radius : radius / 8))};
      const bool onLine = !lines.empty() && random.oneIn(3);
      const Box box = boundsOf(onLine ? lines[random.below(lines.size())] : diagonal);
      std::vector<std::uint32_t> out;
      grid.query(box, out);
      EXPECT_TRUE(std::is_sorted(out.begin(), out.end()) && std::adjacent_find(out.begin(), out.end()) == out.end());
      for (std::uint32_t i = 0; i < lines.size(); ++i) {
        if (!overlaps(lines[i], box)) continue;
        ++found;
        EXPECT_TRUE(std::binary_search(out.begin(), out.end(), i)) << "line " << i << " is missing";
      }
    }
  });
  EXPECT_GT(found, repetitions(1000000));
}

}  // namespace
}  // namespace platon::properties::shape_laws_test
