#include "shared/physics/shape_cache.h"

#include <gtest/gtest.h>

#include "tests/shared/physics/shapes.h"

namespace platon::shape_cache_test {
namespace {

TEST(ShapeCacheTest, ReturnsTheRotatedShape) {
  const Convex base = regular(16, 12288);
  ShapeCache cache;
  for (std::int32_t angle = 0; angle < Angle::kTurn; angle += 600) {
    const Convex* turned = cache.turned(0, base, Angle(angle));
    ASSERT_NE(turned, nullptr);
    EXPECT_EQ(*turned, *base.turned(Angle(angle)));
    EXPECT_EQ(cache.turned(0, base, Angle(angle)), turned) << "made once";
  }
}

TEST(ShapeCacheTest, ReturnsTheBaseForAngleZero) {
  const Convex base = square(5);
  EXPECT_EQ(ShapeCache().turned(3, base, Angle()), &base);
}

TEST(ShapeCacheTest, DistinguishesShapes) {
  const Convex small = square(5);
  const Convex large = square(50);
  ShapeCache cache;
  EXPECT_EQ(*cache.turned(0, small, Angle::degrees(45)), *small.turned(Angle::degrees(45)));
  EXPECT_EQ(*cache.turned(1, large, Angle::degrees(45)), *large.turned(Angle::degrees(45)));
}

TEST(ShapeCacheTest, RotationHullContainsBothShapes) {
  const Convex base = square(5000);
  ShapeCache cache;
  const Convex* hull = cache.rotationHull(0, base, Angle(300), 450);
  ASSERT_NE(hull, nullptr);
  std::vector<Point> points = cache.turned(0, base, Angle(300))->vertices();
  for (const Point vertex : cache.turned(0, base, Angle(750))->vertices()) points.push_back(vertex);
  EXPECT_EQ(hull->vertices(), convexHull(points));
  EXPECT_EQ(cache.rotationHull(0, base, Angle(300), 450), hull) << "made once";
  EXPECT_NE(*cache.rotationHull(0, base, Angle(300), -450), *hull);
  EXPECT_NE(*cache.rotationHull(0, base, Angle(301), 450), *hull);
  EXPECT_NE(*cache.rotationHull(1, square(50), Angle(300), 450), *hull);
}

TEST(ShapeCacheTest, TrimClearsHulls) {
  const Convex base = square(5000);
  ShapeCache cache;
  int turns = 0;
  while (!cache.trim()) cache.rotationHull(0, base, Angle(), ++turns);
  EXPECT_LE(turns, 1024);
  EXPECT_FALSE(cache.trim());
}

TEST(ShapeCacheTest, CachesDegenerateShapes) {
  const Convex sliver(std::vector<Point>{{0, 0}, {3, 1}, {2, 1}});
  ShapeCache cache;
  EXPECT_EQ(cache.turned(0, sliver, Angle::degrees(20)), nullptr);
  EXPECT_EQ(cache.turned(0, sliver, Angle::degrees(20)), nullptr);
  EXPECT_EQ(cache.rotationHull(0, sliver, Angle(), 2000), nullptr);
}

TEST(ShapeCacheTest, TrimChangesNoResult) {
  const Convex base = regular(8, 5000);
  ShapeCache cache;
  const Convex* kept = cache.turned(0, base, Angle(1));
  cache.trim();
  EXPECT_EQ(cache.turned(0, base, Angle(1)), kept) << "few shapes are kept";
  for (std::int32_t angle = 1; angle < 4000; ++angle) {
    ASSERT_EQ(*cache.turned(0, base, Angle(angle)), *base.turned(Angle(angle)));
    cache.trim();
  }
}

}  // namespace
}  // namespace platon::shape_cache_test
