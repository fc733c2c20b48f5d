#include "platon/exact/angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "platon/exact/integer.h"
#include "tests/sim/seeded_random.h"

namespace platon::angle_test {
namespace {

constexpr std::uint64_t kSeed = 20240117;
constexpr std::int64_t kOne = std::int64_t{1} << Rotation::kFractionBits;

long double radians(std::int32_t centidegrees) {
  return static_cast<long double>(centidegrees) * std::numbers::pi_v<long double> / (Angle::kTurn / 2);
}

long double lengthOf(Point vector) { return std::hypot(static_cast<long double>(vector.x), vector.y); }

TEST(AngleTest, ReducesToOneTurn) {
  EXPECT_EQ(Angle().centidegrees(), 0);
  EXPECT_EQ(Angle(36000), Angle());
  EXPECT_EQ(Angle(-1).centidegrees(), 35999);
  EXPECT_EQ(Angle(-36000), Angle());
  EXPECT_EQ(Angle(72001).centidegrees(), 1);
  EXPECT_EQ(Angle(INT32_MAX).centidegrees(), INT32_MAX % 36000);
  EXPECT_EQ(Angle(INT32_MIN).centidegrees(), 36000 + INT32_MIN % 36000);
  EXPECT_EQ(Angle::degrees(90).centidegrees(), 9000);
  EXPECT_EQ(Angle::degrees(-36).centidegrees(), 32400);
  EXPECT_EQ(Angle::degrees(725).centidegrees(), 500);
  EXPECT_EQ(Angle::degrees(INT32_MAX).centidegrees(), INT32_MAX % 360 * 100);
}

TEST(AngleTest, AddsModuloATurn) {
  for (std::int32_t a = 0; a < Angle::kTurn; a += 371) {
    EXPECT_EQ(Angle(a) + -Angle(a), Angle());
    for (std::int32_t b = 0; b < Angle::kTurn; b += 997) {
      EXPECT_EQ((Angle(a) + Angle(b)).centidegrees(), (a + b) % Angle::kTurn);
      EXPECT_EQ(Angle(a) - Angle(b) + Angle(b), Angle(a));
    }
  }
}

TEST(AngleTest, RotationsAreExactTo29Bits) {
  for (std::int32_t centidegrees = 0; centidegrees < Angle::kTurn; ++centidegrees) {
    const Rotation direction = rotationOf(Angle(centidegrees));
    const long double cosine = std::cos(radians(centidegrees)) * kOne;
    const long double sine = std::sin(radians(centidegrees)) * kOne;
    ASSERT_LE(std::abs(static_cast<long double>(direction.cosine) - cosine), 2) << centidegrees;
    ASSERT_LE(std::abs(static_cast<long double>(direction.sine) - sine), 2) << centidegrees;
  }
}

// shared/proof/near.v
TEST(AngleTest, IsARotationAsTheProofDefinesIt) {
  constexpr std::int64_t kWhole = std::int64_t{1} << Rotation::kFractionBits;
  for (std::int32_t centidegrees = 0; centidegrees < Angle::kTurn; ++centidegrees) {
    const auto [cosine, sine] = rotationOf(Angle(centidegrees));
    ASSERT_LE(std::max(std::abs(cosine), std::abs(sine)), kWhole) << centidegrees;
    ASSERT_LE(int128{100} * (cosine * cosine + sine * sine), int128{101} * kWhole * kWhole) << centidegrees;
  }
}

TEST(AngleTest, WholeDegreesAreRoundedCorrectly) {
  for (std::int32_t degrees = 0; degrees < 360; ++degrees) {
    const Rotation direction = rotationOf(Angle::degrees(degrees));
    EXPECT_EQ(direction.cosine, std::llround(std::cos(radians(degrees * 100)) * kOne)) << degrees;
    EXPECT_EQ(direction.sine, std::llround(std::sin(radians(degrees * 100)) * kOne)) << degrees;
  }
}

TEST(AngleTest, QuarterTurnsAreExact) {
  for (const Point vector :
       {Point(1, 0), Point(0, 1), Point(7, -3), Point(kCoordinateLimit - 1, 1 - kCoordinateLimit)}) {
    EXPECT_EQ(rotate(vector, Angle()), vector);
    EXPECT_EQ(rotate(vector, Angle::degrees(90)), perpendicular(vector));
    EXPECT_EQ(rotate(vector, Angle::degrees(180)), -vector);
    EXPECT_EQ(rotate(vector, Angle::degrees(270)), -perpendicular(vector));
  }
}

TEST(AngleTest, QuarterAndHalfTurnsComposeExactly) {
  for (std::int32_t centidegrees = 0; centidegrees < Angle::kTurn; ++centidegrees) {
    const Rotation direction = rotationOf(Angle(centidegrees));
    const Rotation quarter = rotationOf(Angle(centidegrees) + Angle::degrees(90));
    ASSERT_EQ(quarter.cosine, -direction.sine) << centidegrees;
    ASSERT_EQ(quarter.sine, direction.cosine) << centidegrees;
  }
}

TEST(AngleTest, SinesRiseInTheFirstQuarter) {
  for (std::int32_t centidegrees = 0; centidegrees < 9000; ++centidegrees) {
    ASSERT_LT(rotationOf(Angle(centidegrees)).sine, rotationOf(Angle(centidegrees + 1)).sine) << centidegrees;
  }
}

TEST(RotateTest, RoundingIsSymmetric) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Point vector = random.vector(1 << (4 + i % 24));
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    ASSERT_EQ(rotate(-vector, angle), -rotate(vector, angle)) << "seed " << kSeed << ", round " << i;
    ASSERT_EQ(rotate(vector, angle + Angle::degrees(180)), -rotate(vector, angle));
    ASSERT_EQ(rotate(perpendicular(vector), angle), perpendicular(rotate(vector, angle)));
  }
}

TEST(RotateTest, RoundsTheExactRotation) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Point vector = random.vector((1 << (4 + i % 24)) - 1);
    const auto centidegrees = static_cast<std::int32_t>(random.below(Angle::kTurn));
    const long double c = std::cos(radians(centidegrees));
    const long double s = std::sin(radians(centidegrees));
    const Point turned = rotate(vector, Angle(centidegrees));
    const long double reach = 0.5L + lengthOf(vector) * std::ldexp(2.0L, -29);
    ASSERT_LE(std::abs(turned.x - (c * vector.x - s * vector.y)), reach) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(turned.y - (s * vector.x + c * vector.y)), reach) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(lengthOf(turned) - lengthOf(vector)), 2 * reach);
  }
}

TEST(RotateTest, InverseIsWithinASubunit) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const Point vector = random.vector((1 << 26) - 1);
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const Point back = rotate(rotate(vector, angle), -angle) - vector;
    ASSERT_LE(std::abs(back.x), 1) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(back.y), 1) << "seed " << kSeed << ", round " << i;
  }
}

TEST(RotateTest, LargestVectorsStayInRange) {
  constexpr std::int32_t largest = 2 * (kCoordinateLimit - 1);
  for (std::int32_t centidegrees = 0; centidegrees < Angle::kTurn; centidegrees += 100) {
    const Point turned = rotate(Point(largest, largest), Angle(centidegrees));
    const long double expected = largest * (std::cos(radians(centidegrees)) - std::sin(radians(centidegrees)));
    ASSERT_LE(std::abs(turned.x - expected), 8) << centidegrees;
  }
}

TEST(AngleBetweenTest, FindsEveryAngleOfALongVector) {
  const Point from(1 << 28, 0);
  for (std::int32_t centidegrees = 0; centidegrees < Angle::kTurn; ++centidegrees) {
    ASSERT_EQ(angleBetween(from, rotate(from, Angle(centidegrees))).centidegrees(), centidegrees);
  }
}

TEST(AngleBetweenTest, IsIndependentOfLengths) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const Point from = random.vector(1 << 20);
    if (squaredLength(from) < std::int64_t{1} << 38) continue;
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const Point to = rotate(Point(from.x * 100, from.y * 100), angle);
    ASSERT_EQ(angleBetween(from, to), angle) << "seed " << kSeed << ", round " << i;
    ASSERT_EQ(angleBetween(to, from), -angle) << "seed " << kSeed << ", round " << i;
  }
}

TEST(AngleBetweenTest, RoundsToNearestCentidegree) {
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      if (x == 0 && y == 0) continue;
      const long double turn = std::atan2(static_cast<long double>(y), static_cast<long double>(x)) /
                               std::numbers::pi_v<long double> * (Angle::kTurn / 2);
      const Angle expected(static_cast<std::int32_t>(std::llround(turn)));
      EXPECT_EQ(angleBetween(Point(1, 0), Point(x, y)), expected) << x << " " << y;
      EXPECT_EQ(angleBetween(Point(0, -3), Point(x, y)), expected + Angle::degrees(90)) << x << " " << y;
    }
  }
}

TEST(AngleBetweenTest, IsExactForQuarterTurns) {
  for (const Point vector : {Point(1, 0), Point(-5, 3), Point(kCoordinateLimit, -1), Point(0, -kCoordinateLimit)}) {
    EXPECT_EQ(angleBetween(vector, vector), Angle());
    EXPECT_EQ(angleBetween(vector, -vector), Angle::degrees(180));
    EXPECT_EQ(angleBetween(vector, perpendicular(vector)), Angle::degrees(90));
    EXPECT_EQ(angleBetween(vector, -perpendicular(vector)), Angle::degrees(270));
  }
}

}  // namespace
}  // namespace platon::angle_test
