#include "platon/exact/point.h"

#include <gtest/gtest.h>

#include "platon/exact/integer.h"

namespace platon::point_test {
namespace {

TEST(PointTest, AddsAndSubtracts) {
  EXPECT_EQ(Point(3, 4) + Point(-1, 2), Point(2, 6));
  EXPECT_EQ(Point(3, 4) - Point(-1, 2), Point(4, 2));
  EXPECT_EQ(-Point(3, -4), Point(-3, 4));
  Point point(1, 1);
  point += Point(2, 3);
  EXPECT_EQ(point, Point(3, 4));
  point -= Point(3, 4);
  EXPECT_EQ(point, Point());
  EXPECT_NE(Point(1, 2), Point(2, 1));
}

TEST(PointTest, ProductsHaveTheDocumentedSigns) {
  EXPECT_EQ(dot(Point(3, 4), Point(2, -1)), 2);
  EXPECT_EQ(cross(Point(1, 0), Point(0, 1)), 1);
  EXPECT_EQ(cross(Point(0, 1), Point(1, 0)), -1);
  EXPECT_EQ(squaredLength(Point(-3, 4)), 25);
  EXPECT_EQ(perpendicular(Point(2, 1)), Point(-1, 2));
}

TEST(PointTest, ProductsAreExactUpToTheBounds) {
  constexpr std::int32_t largest = 2 * (kCoordinateLimit - 1);
  constexpr std::int64_t square = std::int64_t{largest} * largest;
  EXPECT_EQ(dot(Point(largest, largest), Point(largest, largest)), 2 * square);
  EXPECT_EQ(cross(Point(largest, -largest), Point(largest, largest)), 2 * square);
  EXPECT_EQ(dot(Point(INT32_MAX, -INT32_MAX), Point(-INT32_MAX, INT32_MAX)), -2 * std::int64_t{INT32_MAX} * INT32_MAX);
  EXPECT_EQ(cross(Point(largest, largest - 1), Point(largest - 1, largest - 2)), -1);
}

}  // namespace
}  // namespace platon::point_test
