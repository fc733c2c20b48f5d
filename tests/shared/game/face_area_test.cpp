#include "shared/game/face_area.h"

#include <gtest/gtest.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "platon/game/solid.h"

namespace platon::face_area_test {
namespace {

constexpr std::array kKinds = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kDodecahedron};

FinePoint units(std::int64_t x, std::int64_t y) {
  return {x * kSubunitsPerUnit * FinePoint::kPerSubunit, y * kSubunitsPerUnit * FinePoint::kPerSubunit};
}

FinePoint fine(Point point) { return {point.x * FinePoint::kPerSubunit, point.y * FinePoint::kPerSubunit}; }

// Largest distance of a point outside an edge of the polygon, in subunits; negative inside the polygon.
double beyond(const std::vector<Point>& polygon, Point point) {
  double largest = -1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length = std::sqrt(static_cast<double>(squaredLength(edge)));
    largest = std::max(largest, static_cast<double>(-cross(edge, point - polygon[i])) / length);
  }
  return largest;
}

struct ExactPoint {
  mpq_class x;
  mpq_class y;
};

// The ends of the part of a–b inside the polygon, clipped in rationals; empty when there is none.
std::vector<ExactPoint> exactCut(const std::vector<Point>& polygon, FinePoint a, FinePoint b) {
  const ExactPoint from{mpq_class(a.x, 625), mpq_class(a.y, 625)};
  const ExactPoint to{mpq_class(b.x, 625), mpq_class(b.y, 625)};
  mpq_class first = 0;
  mpq_class last = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point corner = polygon[i];
    const Point edge = polygon[(i + 1) % polygon.size()] - corner;
    const mpq_class sideA = edge.x * (from.y - corner.y) - edge.y * (from.x - corner.x);
    const mpq_class sideB = edge.x * (to.y - corner.y) - edge.y * (to.x - corner.x);
    if (sideA < 0 && sideB < 0) return {};
    if (sideA < 0) first = std::max(first, mpq_class(sideA / (sideA - sideB)));
    if (sideB < 0) last = std::min(last, mpq_class(sideA / (sideA - sideB)));
  }
  if (last < first) return {};
  const auto at = [&](const mpq_class& t) {
    return ExactPoint{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
  };
  return {at(first), at(last)};
}

bool isNearest(Point point, const ExactPoint& exact) {
  const mpq_class half(1, 2);
  return abs(point.x - exact.x) <= half && abs(point.y - exact.y) <= half;
}

class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : random_(seed) {}
  std::int64_t below(std::int64_t limit) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(limit));
  }
  // A coordinate with four decimals, as level texts have them, up to `largest` units in magnitude.
  std::int64_t coordinate(std::int64_t largest) { return (below(2 * largest * 10000 + 1) - largest * 10000) * 64; }
  FinePoint point(std::int64_t largest) {
    const std::int64_t x = coordinate(largest);
    return {x, coordinate(largest)};
  }

 private:
  std::mt19937_64 random_;
};

TEST(FaceAreaTest, ALineInsideIsOnlyRounded) {
  const FaceArea area(facePolygon(SolidKind::kHexahedron, 480));
  EXPECT_EQ(area.clip(units(-240, -200), units(100, -200)),
            (Segment{{-240 * 1024, -200 * 1024}, {100 * 1024, -200 * 1024}}));
  EXPECT_EQ(area.clip({312, -313}, {313, 0}), (Segment{{0, -1}, {1, 0}}));
  EXPECT_EQ(area.clip(units(3, 4), units(3, 4)), (Segment{{3072, 4096}, {3072, 4096}}));
}

TEST(FaceAreaTest, ALineThatLeavesTheFaceIsClippedAtTheEdge) {
  const FaceArea area(facePolygon(SolidKind::kHexahedron, 480));
  EXPECT_EQ(area.clip(units(0, 0), units(300, 0)), (Segment{{0, 0}, {245760, 0}}));
  EXPECT_EQ(area.clip(units(-300, 50), units(300, 50)), (Segment{{-245760, 51200}, {245760, 51200}}));
  EXPECT_EQ(area.clip(units(-480, -480), units(480, 480)), (Segment{{-245760, -245760}, {245760, 245760}}));
  EXPECT_EQ(area.clip(units(220, 0), units(260, 30)), (Segment{{225280, 0}, {245760, 15360}}));
}

TEST(FaceAreaTest, ALineOutsideGivesNothing) {
  const FaceArea square(facePolygon(SolidKind::kHexahedron, 480));
  EXPECT_FALSE(square.clip(units(241, -100), units(241, 100)));
  EXPECT_FALSE(square.clip(units(200, 300), units(300, 200)));
  EXPECT_FALSE(square.clip(units(300, 0), units(131072, 0)));
  EXPECT_FALSE(square.clip(units(0, 245), units(0, 245)));
  const FaceArea triangle(facePolygon(SolidKind::kOctahedron, 480));
  EXPECT_FALSE(triangle.clip(units(-200, 275), units(200, 280)));
  EXPECT_TRUE(triangle.clip(units(-200, 270), units(200, 280)));
}

TEST(FaceAreaTest, ALineOneSubunitOutsideIsOnTheEdge) {
  const FaceArea area(facePolygon(SolidKind::kHexahedron, 480));
  const Segment beside{{245761, -1000}, {245761, 1000}};
  EXPECT_EQ(area.clip(fine(beside.a), fine(beside.b)), beside);
  EXPECT_FALSE(area.clip(fine({245762, -1000}), fine({245762, 1000})));
  EXPECT_EQ(area.clip(fine({0, 0}), fine({245761, 0})), (Segment{{0, 0}, {245761, 0}}));
  EXPECT_EQ(area.clip(fine({0, 0}), fine({245762, 0})), (Segment{{0, 0}, {245760, 0}}));
}

TEST(FaceAreaTest, ContainsItsEdgesButNoPointOutside) {
  for (const SolidKind kind : kKinds) {
    const auto polygon = facePolygon(kind, 333);
    const FaceArea area(polygon);
    EXPECT_TRUE(area.contains({0, 0}));
    for (const Point corner : polygon) {
      EXPECT_TRUE(area.contains(corner));
      EXPECT_FALSE(area.contains(corner + Point(corner.x > 0 ? 1 : -1, corner.y > 0 ? 1 : -1)));
    }
    EXPECT_TRUE(area.contains({0, polygon[0].y}));
    EXPECT_FALSE(area.contains({0, polygon[0].y - 1}));
  }
}

TEST(FaceAreaTest, ALineWrittenAlongAnEdgeEqualsTheEdge) {
  for (const SolidKind kind : kKinds) {
    for (std::int32_t size = kMinFaceSize; size < 1500; size += 7) {
      const auto polygon = facePolygon(kind, size);
      const FaceArea area(polygon);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto written = [](Point corner) {  // with four decimals
          const auto decimal = [](std::int32_t subunits) {
            return divideRounded<std::int64_t>(std::int64_t{subunits} * 10000, 1024) * 64;
          };
          return FinePoint{decimal(corner.x), decimal(corner.y)};
        };
        const Point next = polygon[(i + 1) % polygon.size()];
        EXPECT_EQ(area.clip(written(polygon[i]), written(next)), (Segment{polygon[i], next})) << size << ", edge " << i;
      }
    }
  }
}

TEST(FaceAreaTest, ClippedEndsAreRoundedToTheNearest) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  RandomPoints random(seed);
  int clipped = 0;
  for (int i = 0; i < 30000; ++i) {
    const auto size = static_cast<std::int32_t>(i % 3 == 0 ? kMaxFaceSize : 200 + random.below(2000));
    const auto polygon = facePolygon(kKinds[static_cast<std::size_t>(i) % 3], size);
    const std::int64_t largest = i % 2 == 0 ? FaceArea::kMaxUnits : size;
    const FinePoint a = random.point(largest);
    const FinePoint b = random.point(largest);
    const auto found = FaceArea(polygon).clip(a, b);
    const auto expected = exactCut(polygon, a, b);
    if (expected.empty()) {
      // `clip` may still find a line that is within one subunit of the face.
      EXPECT_LE(found ? beyond(polygon, found->a) : 0, 1.0);
      continue;
    }
    ++clipped;
    ASSERT_TRUE(found);
    EXPECT_TRUE(isNearest(found->a, expected[0]) || beyond(polygon, found->a) > 0);
    EXPECT_TRUE(isNearest(found->b, expected[1]) || beyond(polygon, found->b) > 0);
    EXPECT_LE(beyond(polygon, found->a), 1.0);
    EXPECT_LE(beyond(polygon, found->b), 1.0);
  }
  EXPECT_GT(clipped, 5000);
}

TEST(FaceAreaTest, NoEndIsMoreThanOneSubunitOutside) {
  constexpr std::uint64_t seed = 12;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  RandomPoints random(seed);
  int kept = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto polygon = facePolygon(kKinds[static_cast<std::size_t>(i) % 3], static_cast<std::int32_t>(200 + i % 97));
    const auto corner = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(polygon.size())));
    const Point from = polygon[corner];
    const Point to = polygon[(corner + 1) % polygon.size()];
    const auto near = [&](Point base) {  // up to 1.5 subunits beside the edge, at its end or 0.1 edges farther along it
      const FinePoint exact = fine(base);
      const std::int64_t along = random.below(3) - 1;
      return FinePoint{exact.x + along * (to.x - from.x) * 64 + random.below(3750) - 1875,
                       exact.y + along * (to.y - from.y) * 64 + random.below(3750) - 1875};
    };
    const auto found = FaceArea(polygon).clip(near(from), near(to));
    if (!found) continue;
    ++kept;
    ASSERT_LE(beyond(polygon, found->a), 1.0) << i;
    ASSERT_LE(beyond(polygon, found->b), 1.0) << i;
  }
  EXPECT_GT(kept, 10000);
}

}  // namespace
}  // namespace platon::face_area_test
