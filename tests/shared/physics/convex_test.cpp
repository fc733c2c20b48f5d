#include "platon/physics/convex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "platon/exact/integer.h"
#include "tests/shared/physics/shapes.h"

namespace platon::convex_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

constexpr std::uint64_t kSeed = 31;
constexpr std::int32_t kMax = kCoordinateLimit - 1;

using Points = std::vector<Point>;

TEST(ConvexFaultTest, AcceptsStrictlyConvexPolygons) {
  EXPECT_EQ(Convex::fault(Points{{0, 0}, {1, 0}, {0, 1}}), std::nullopt);
  EXPECT_EQ(Convex::fault(Points{{0, 0}, {10, 0}, {10, 10}, {0, 10}}), std::nullopt);
  EXPECT_EQ(Convex::fault(Points{{-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax}}), std::nullopt);
  EXPECT_EQ(Convex::fault(Points{{-kMax, -kMax}, {kMax, kMax - 1}, {kMax, kMax}}), std::nullopt);
}

TEST(ConvexFaultTest, NeedsThreeVertices) {
  EXPECT_THAT(Convex::fault(Points{}), Optional(std::string("a shape needs at least 3 vertices, not 0")));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {1, 1}}), Optional(std::string("a shape needs at least 3 vertices, not 2")));
}

TEST(ConvexFaultTest, NamesTheVertexOutOfRange) {
  const std::string reason = " is out of range: coordinates must be below 2^29 in magnitude";
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {kMax + 1, 0}, {0, 1}}),
              Optional("vertex 2 of 3, (536870912, 0)," + reason));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {1, 0}, {0, -kMax - 1}}),
              Optional("vertex 3 of 3, (0, -536870912)," + reason));
  EXPECT_THAT(Convex::fault(Points{{INT32_MIN, 0}, {1, 0}, {0, 1}}),
              Optional("vertex 1 of 3, (-2147483648, 0)," + reason));
}

TEST(ConvexFaultTest, NamesTheCollinearVertex) {
  const std::string reason = " is collinear with its neighbours: remove it";
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {5, 0}, {10, 0}, {10, 10}}), Optional("vertex 2 of 4, (5, 0)," + reason));
  EXPECT_THAT(Convex::fault(Points{{5, 0}, {10, 0}, {10, 10}, {0, 0}}), Optional("vertex 1 of 4, (5, 0)," + reason));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {10, 0}, {5, 0}}), Optional("vertex 2 of 3, (10, 0)," + reason))
      << "a spike";
}

// A first vertex that was repeated at the end was called collinear.
TEST(ConvexFaultTest, NamesTheVertexThatIsRepeated) {
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}),
              Optional(std::string("vertex 5 of 5, (0, 0), equals vertex 1: remove it")));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {0, 0}, {10, 0}, {10, 10}}),
              Optional(std::string("vertex 2 of 4, (0, 0), equals vertex 1: remove it")));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {10, 0}, {10, 10}, {10, 10}}),
              Optional(std::string("vertex 3 of 4, (10, 10), equals vertex 4: remove it")));
  EXPECT_THAT(Convex::fault(Points{{3, 3}, {3, 3}, {3, 3}}),
              Optional(std::string("vertex 2 of 3, (3, 3), equals vertex 1: remove it")));
}

TEST(ConvexFaultTest, NamesTheVertexThatTurnsClockwise) {
  const std::string reason = " turns clockwise: a shape must be convex and counter-clockwise";
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {0, 10}, {10, 10}, {10, 0}}), Optional("vertex 2 of 4, (0, 10)," + reason));
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {10, 0}, {10, 10}, {9, 1}}), Optional("vertex 4 of 4, (9, 1)," + reason))
      << "a dent";
  EXPECT_THAT(Convex::fault(Points{{0, 0}, {10, 10}, {10, 0}, {0, 10}}), Optional("vertex 2 of 4, (10, 10)," + reason))
      << "a bow tie";
}

TEST(ConvexFaultTest, RejectsPolygonsThatWindTwice) {
  const Convex pentagon = regular(5, 1000);
  Points star;
  for (std::size_t i = 0; i < 5; ++i) star.push_back(pentagon.vertices()[2 * i % 5]);
  EXPECT_THAT(Convex::fault(star), Optional(std::string("the edges wind around more than once")));
  Points twice = pentagon.vertices();
  for (const Point vertex : pentagon.vertices()) twice.push_back(vertex);
  EXPECT_THAT(Convex::fault(twice), Optional(std::string("the edges wind around more than once")));
}

TEST(ConvexTest, ThrowsTheFault) {
  EXPECT_THROW(
      {
        try {
          Convex shape(Points{{0, 0}, {1, 0}});
        } catch (const std::invalid_argument& reason) {
          EXPECT_STREQ(reason.what(), "a shape needs at least 3 vertices, not 2");
          throw;
        }
      },
      std::invalid_argument);
  intern::Convex draft;
  draft.vertices = {{0, 0}, {0, 1}, {1, 0}};
  EXPECT_THROW(Convex{draft}, std::invalid_argument);
}

TEST(ConvexTest, EdgeNormalsPointInwards) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Convex shape = randomConvex(random, 1 << (2 + i % 26));
    const auto& vertices = shape.vertices();
    ASSERT_EQ(shape.edges().size(), vertices.size());
    for (std::size_t edge = 0; edge < vertices.size(); ++edge) {
      const auto& [normal, support] = shape.edges()[edge];
      ASSERT_EQ(normal, perpendicular(vertices[(edge + 1) % vertices.size()] - vertices[edge]));
      for (const Point vertex : vertices)
        ASSERT_GE(dot(normal, vertex), support) << "seed " << kSeed << ", round " << i;
      ASSERT_EQ(dot(normal, vertices[edge]), support);
      ASSERT_EQ(dot(normal, vertices[(edge + 1) % vertices.size()]), support);
    }
  }
}

TEST(ConvexTest, ComputesBoundsAndCentre) {
  const Convex shape(Points{{0, 0}, {10, 0}, {10, 11}, {1, 11}});
  EXPECT_EQ(shape.bounds().low, Point(0, 0));
  EXPECT_EQ(shape.bounds().high, Point(10, 11));
  EXPECT_EQ(shape.centre(), Point(5, 6)) << "21 / 4 and 22 / 4, halves away from zero";
  EXPECT_EQ(Convex(Points{{0, 0}, {-1, 0}, {-1, -2}}).centre(), Point(-1, -1));
  EXPECT_EQ(Convex(Points{{-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax}}).centre(), Point());
  EXPECT_EQ(regular(16, 12288).centre(), Point());
}

TEST(ConvexTest, EqualityComparesVerticesInOrder) {
  EXPECT_EQ(square(5), square(5));
  EXPECT_FALSE(square(5) == square(6));
  EXPECT_FALSE(Convex(Points{{0, 0}, {1, 0}, {0, 1}}) == Convex(Points{{1, 0}, {0, 1}, {0, 0}}));
}

TEST(ConvexTurnedTest, QuarterTurnsAreExact) {
  const Convex shape(Points{{0, 0}, {10, 0}, {10, 11}, {1, 11}});
  EXPECT_EQ(shape.turned(Angle()), shape);
  EXPECT_EQ(shape.turned(Angle::degrees(90)), Convex(Points{{0, 0}, {0, 10}, {-11, 10}, {-11, 1}}));
  EXPECT_EQ(shape.turned(Angle::degrees(180)), Convex(Points{{0, 0}, {-10, 0}, {-10, -11}, {-1, -11}}));
  EXPECT_EQ(regular(16, 12288).turned(Angle::degrees(90))->bounds().high, regular(16, 12288).bounds().high);
}

TEST(ConvexTurnedTest, FaceTurnsKeepTheNumberOfVertices) {
  for (const int degrees : {36, 60, 72, 108, 120, 144, 180, 216, 252, 288, 300, 324}) {
    for (const int count : {3, 4, 5, 6, 8, 16}) {
      const Convex base = regular(count, 12288);
      const auto turned = base.turned(Angle::degrees(degrees));
      ASSERT_TRUE(turned);
      ASSERT_EQ(turned->vertices().size(), base.vertices().size());
      for (std::size_t i = 0; i < base.vertices().size(); ++i) {
        EXPECT_EQ(turned->vertices()[i], rotate(base.vertices()[i], Angle::degrees(degrees)))
            << count << " " << degrees;
      }
    }
  }
}

TEST(ConvexTurnedTest, ContainsEveryRotatedVertex) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 3000; ++i) {
    const Convex base = randomConvex(random, 3 << (i % 20));
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const auto turned = base.turned(angle);
    if (!turned) continue;
    EXPECT_EQ(Convex::fault(turned->vertices()), std::nullopt);
    for (const Point vertex : base.vertices()) {
      const Point image = rotate(vertex, angle);
      for (const auto& edge : turned->edges()) {
        ASSERT_GE(dot(edge.normal, image), edge.support) << "seed " << kSeed << ", round " << i;
      }
    }
  }
}

// The convex hull of a cluster of up to four points and of two or three distant ones. The vertices of the cluster can
// become collinear when the shape is rotated and rounded.
Points clusteredHull(sim::SeededRandom& random, std::int32_t radius) {
  Points points;
  const Point cluster = random.vector(radius);
  for (std::uint64_t left = 1 + random.below(4); left != 0; --left) points.push_back(cluster + random.vector(4));
  for (std::uint64_t left = 2 + random.below(2); left != 0; --left) points.push_back(random.vector(radius));
  return convexHull(points);
}

// The largest coordinate of `point` minus the image of `centre`, in 2^-30 subunits.
std::int64_t wideError(Point point, Point centre, Angle angle) {
  const WideVector image = rotateWide(centre, rotationOf(angle));
  constexpr std::int64_t one = std::int64_t{1} << Rotation::kFractionBits;
  return std::max(std::abs(point.x * one - image.x), std::abs(point.y * one - image.y));
}

// The mean of the hull's vertices is up to 5 000 subunits from the image of the centre, because a hull that has lost a
// vertex has another mean.
TEST(ConvexTurnedTest, ALostVertexDoesNotMoveTheCentre) {
  sim::SeededRandom random(kSeed);
  constexpr std::int64_t half = std::int64_t{1} << (Rotation::kFractionBits - 1);
  int lost = 0;
  std::int64_t worstMean = 0;
  for (int i = 0; i < 3000; ++i) {
    const Points hull = clusteredHull(random, 12288);
    if (Convex::fault(hull)) continue;
    const Convex base(hull);
    for (int k = 0; k < 40; ++k) {
      const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
      const auto turned = base.turned(angle);
      if (!turned) continue;
      ASSERT_LE(wideError(turned->centre(), base.centre(), angle), half) << "seed " << kSeed << ", round " << i;
      if (turned->vertices().size() == hull.size()) continue;
      ++lost;
      worstMean = std::max(worstMean, wideError(Convex(turned->vertices()).centre(), base.centre(), angle));
    }
  }
  EXPECT_GT(lost, 1000);
  EXPECT_GT(worstMean >> Rotation::kFractionBits, 1000) << "the search finds means that jump";
}

TEST(ConvexTurnedTest, TheCentreIsPartOfTheShape) {
  const Convex base(Points{{11000, -4345}, {8598, 8352}, {-10172, -2194}, {10999, -4345}});
  const auto turned = base.turned(Angle(3001));
  ASSERT_TRUE(turned);
  ASSERT_EQ(turned->vertices().size(), 3u);
  EXPECT_EQ(turned->centre(), rotate(base.centre(), Angle(3001)));
  const Convex same(turned->vertices());
  EXPECT_GT(squaredLength(same.centre() - turned->centre()), 2000 * 2000);
  EXPECT_FALSE(same == *turned) << "equal vertices, another centre";
}

TEST(ConvexTurnedTest, TinyShapesCanDegenerate) {
  const Convex sliver(Points{{0, 0}, {3, 1}, {2, 1}});
  EXPECT_EQ(sliver.turned(Angle::degrees(20)), std::nullopt);
  EXPECT_NE(sliver.turned(Angle::degrees(90)), std::nullopt);
  EXPECT_EQ(square(kMax).turned(Angle::degrees(45)), std::nullopt) << "the vertices would be out of range";
}

TEST(ConvexHullTest, HandlesFewPoints) {
  EXPECT_THAT(convexHull({}), IsEmpty());
  EXPECT_THAT(convexHull({{1, 2}}), ElementsAre(Point(1, 2)));
  EXPECT_LT(convexHull({{0, 0}, {1, 1}, {2, 2}, {1, 1}}).size(), 3u);
  EXPECT_LT(convexHull({{5, 5}, {5, 5}, {5, 5}}).size(), 3u);
  EXPECT_THAT(convexHull({{9, 0}, {0, 0}, {0, 9}, {2, 2}}), ElementsAre(Point(9, 0), Point(0, 9), Point(0, 0)));
  EXPECT_THAT(convexHull({{1, 1}, {0, 0}, {9, 0}, {0, 9}}), ElementsAre(Point(0, 0), Point(9, 0), Point(0, 9)));
}

TEST(ConvexHullTest, IsTheSmallestConvexPolygonAroundThePoints) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 3000; ++i) {
    Points points;
    const std::uint64_t count = 1 + random.below(20);
    for (std::uint64_t k = 0; k < count; ++k) points.push_back(random.vector(2 << (i % 27)));
    const Points hull = convexHull(points);
    for (const Point vertex : hull) ASSERT_NE(std::find(points.begin(), points.end(), vertex), points.end());
    if (hull.size() < 3) {
      for (const Point point : points) ASSERT_EQ(cross(point - points[0], hull.back() - hull[0]), 0);
      continue;
    }
    ASSERT_EQ(Convex::fault(hull), std::nullopt) << "seed " << kSeed << ", round " << i;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Point edge = hull[(k + 1) % hull.size()] - hull[k];
      for (const Point point : points)
        ASSERT_GE(cross(edge, point - hull[k]), 0) << "seed " << kSeed << ", round " << i;
    }
    const auto onHull = [&](Point point) { return std::find(hull.begin(), hull.end(), point) != hull.end(); };
    ASSERT_EQ(hull[0], *std::find_if(points.begin(), points.end(), onHull)) << "the first of the given points";
    Points reversed(points.rbegin(), points.rend());
    const Points again = convexHull(reversed);
    ASSERT_TRUE(std::is_permutation(hull.begin(), hull.end(), again.begin(), again.end()));
  }
}

}  // namespace
}  // namespace platon::convex_test
