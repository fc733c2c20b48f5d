#include "shared/physics/slide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "platon/exact/integer.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon {
namespace {

constexpr std::uint64_t kSeed = 12;

// The laws of every slide. They also hold for displacements that lead outwards, which a step does not slide.
void expectSlides(Point displacement, Point normal) {
  const Point slid = slideAlong(displacement, normal);
  ASSERT_GE(dot(slid, normal), 0) << "never inwards";
  const long double length = std::hypot(static_cast<long double>(normal.x), normal.y);
  ASSERT_LT(static_cast<long double>(dot(slid, normal)) / length, 1.0L) << "less than a subunit outwards";
  const Point tangent = perpendicular(normal);
  const long double along = static_cast<long double>(dot(displacement, tangent)) / length;
  const long double slidAlong = static_cast<long double>(dot(slid, tangent)) / length;
  const auto lengthOf = [](Point p) { return std::hypot(static_cast<long double>(p.x), p.y); };
  ASSERT_LE(lengthOf(slid), lengthOf(displacement) + 0.71L) << "longer by at most the rounding outwards";
  if (slid == Point()) {
    ASSERT_LT(std::abs(along), 1.42L) << "shorter than a subunit along the dominant axis";
    return;
  }
  ASSERT_GT(along * slidAlong, 0.0L) << "forwards";
  // Truncation removes less than a subunit along the dominant axis; the other axis is rounded by less than one.
  ASSERT_GE(std::abs(slidAlong), std::abs(along) - 2.13L);
}

TEST(SlideTest, KeepsTheComponentAlongAnAxis) {
  EXPECT_EQ(slideAlong({7, -3}, {0, 1}), Point(7, 0));
  EXPECT_EQ(slideAlong({7, -3}, {0, 1000}), Point(7, 0));
  EXPECT_EQ(slideAlong({7, 3}, {0, -2}), Point(7, 0));
  EXPECT_EQ(slideAlong({7, -3}, {-5, 0}), Point(0, -3));
  EXPECT_EQ(slideAlong({-7, -3}, {5, 0}), Point(0, -3));
}

TEST(SlideTest, IsZeroStraightIntoTheSegment) {
  EXPECT_EQ(slideAlong({0, -100}, {0, 1}), Point());
  EXPECT_EQ(slideAlong({-300, -400}, {3, 4}), Point());
  EXPECT_EQ(slideAlong({1 << 29, 1 << 29}, {-1, -1}), Point());
}

TEST(SlideTest, RoundsOutwardsAlongADiagonal) {
  EXPECT_EQ(slideAlong({10, 0}, {-1, 1}), Point(5, 5));
  EXPECT_EQ(slideAlong({0, -10}, {-1, 1}), Point(-5, -5));
  EXPECT_EQ(slideAlong({10, 0}, {1, 1}), Point(5, -5));
  EXPECT_EQ(slideAlong({10, 0}, {-1, 3}), Point(9, 3));
  EXPECT_EQ(slideAlong({9, 0}, {-1, 3}), Point(8, 3)) << "8.1 is truncated to 8, then y is rounded outwards";
  EXPECT_EQ(slideAlong({9, 0}, {1, 3}), Point(8, -2)) << "outwards is upwards here, too";
}

TEST(SlideTest, IsZeroBelowASubunit) {
  EXPECT_EQ(slideAlong({1, 0}, {-1, 3}), Point());
  EXPECT_EQ(slideAlong({0, 0}, {-1, 3}), Point());
  EXPECT_EQ(slideAlong({1, -1000}, {0, 1}), Point(1, 0));
}

TEST(SlideTest, HoldsForAllSmallVectors) {
  for (int nx = -5; nx <= 5; ++nx) {
    for (int ny = -5; ny <= 5; ++ny) {
      if (nx == 0 && ny == 0) continue;
      for (int x = -12; x <= 12; ++x) {
        for (int y = -12; y <= 12; ++y) {
          ASSERT_NO_FATAL_FAILURE(expectSlides({x, y}, {nx, ny})) << x << " " << y << " " << nx << " " << ny;
        }
      }
    }
  }
}

TEST(SlideTest, HoldsForRandomVectorsUpToTheBounds) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 200000; ++i) {
    const Point displacement = random.vector((2 << (i % 27)) - 1);
    const Point normal = random.vector((2 << (i % 26)) - 1);
    if (normal == Point()) continue;
    ASSERT_NO_FATAL_FAILURE(expectSlides(displacement, normal)) << "seed " << kSeed << ", round " << i;
  }
  constexpr std::int32_t largest = (1 << 30) - 1;
  ASSERT_NO_FATAL_FAILURE(expectSlides({largest, -largest}, {largest, largest - 1}));
  ASSERT_NO_FATAL_FAILURE(expectSlides({-largest, largest}, {1, -largest}));
}

TEST(TurnedNormalTest, Uses29BitsAndKeepsTheDirection) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 50000; ++i) {
    const Point normal = random.vector((2 << (i % 27)) - 1);
    if (normal == Point()) continue;
    const auto centidegrees = static_cast<std::int32_t>(random.below(Angle::kTurn));
    const Point turned = turnedNormal(normal, Angle(centidegrees));
    const auto longest = std::max(std::abs(turned.x), std::abs(turned.y));
    ASSERT_LE(longest, 1 << 29) << "seed " << kSeed << ", round " << i;
    ASSERT_GE(longest, 1 << 28) << "seed " << kSeed << ", round " << i;
    const long double expected = std::atan2(static_cast<long double>(normal.y), static_cast<long double>(normal.x)) +
                                 centidegrees * std::numbers::pi_v<long double> / 18000;
    const long double miss =
        std::atan2(static_cast<long double>(turned.y), static_cast<long double>(turned.x)) - expected;
    ASSERT_LT(std::abs(std::sin(miss)), std::ldexp(1.0L, -27)) << "seed " << kSeed << ", round " << i;
    ASSERT_GT(std::cos(miss), 0.0L) << "seed " << kSeed << ", round " << i;
  }
}

TEST(TurnedNormalTest, QuarterTurnsAreExact) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Point turned = turnedNormal({3, 1}, Angle::degrees(90 * quarter));
    EXPECT_EQ(cross(turned, rotate(Point(3, 1), Angle::degrees(90 * quarter))), 0);
    EXPECT_GT(dot(turned, rotate(Point(3, 1), Angle::degrees(90 * quarter))), 0);
  }
}

TEST(DominantStepTest, FollowsTheDominantAxis) {
  EXPECT_EQ(dominantStep({5, 3}), Point(1, 0));
  EXPECT_EQ(dominantStep({-5, 3}), Point(-1, 0));
  EXPECT_EQ(dominantStep({2, 3}), Point(0, 1));
  EXPECT_EQ(dominantStep({2, -3}), Point(0, -1));
  EXPECT_EQ(dominantStep({4, -4}), Point(1, 0));
  EXPECT_EQ(dominantStep({INT32_MIN, 1}), Point(-1, 0));
}

// A shape that touches a segment, and a displacement along it in either direction.
struct Touching {
  Convex shape;
  Point position;
  Segment line;
  Point normal;
  Point displacement;
};

Touching anyTouching(sim::SeededRandom& random) {
  const std::int32_t size = std::int32_t{1} << (4 + random.below(20));
  Point along = random.vector(size);
  if (along == Point()) along.x = 1;
  const auto parts = static_cast<std::int32_t>(1 + random.below(16));
  const Point a = random.vector(1000);
  Touching scene{
      randomConvex(random, 300), {}, {a, {a.x + along.x * parts, a.y + along.y * parts}}, {along.y, -along.x}, {}};
  Point foot = scene.shape.vertices()[0];
  for (const Point vertex : scene.shape.vertices()) {
    if (dot(scene.normal, vertex) < dot(scene.normal, foot)) foot = vertex;
  }
  const auto part = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(parts)));
  scene.position = Point(a.x + along.x * part, a.y + along.y * part) - foot;
  scene.displacement = random.vector(1 + size * parts / 4);
  if (random.below(2) == 0) std::swap(scene.line.a, scene.line.b);
  return scene;
}

TEST(ExtendsBeyondTest, LimitsDoNotShortenTheSlide) {
  sim::SeededRandom random(kSeed);
  int continuing = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto [shape, position, line, normal, displacement] = anyTouching(random);
    const Point tangent = perpendicular(normal);
    const bool back = dot(displacement, tangent) < 0;
    if (!extendsBeyond(maxNorm(displacement), shape.bounds(), position, line, back ? -tangent : tangent)) continue;
    ++continuing;
    SlideLimits limits;
    (back ? limits.backward : limits.forward) = maxNorm(displacementToEdgeEnd(shape, position, line, normal, back));
    ASSERT_EQ(slideAlong(displacement, normal, limits), slideAlong(displacement, normal))
        << "seed " << kSeed << ", round " << i;
  }
  EXPECT_GT(continuing, 5000);
}

}  // namespace
}  // namespace platon
