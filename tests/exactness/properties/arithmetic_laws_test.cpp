// Laws of exact arithmetic on random, degenerate and extreme values, compared with GMP.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <compare>

#include "platon/exact/angle.h"
#include "platon/exact/fraction.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "shared/exact/square_root.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::arithmetic_laws_test {
namespace {

using oracle::RandomSource;

const std::int64_t kCases = repetitions(200000);
constexpr std::int64_t kLargest = std::int64_t{1} << 62;

// Requires |value| < 2^126.
mpz_class big(int128 value) {
  constexpr int bits = 62;
  const int128 magnitude = value < 0 ? -value : value;
  const auto low = static_cast<long>(magnitude & ((int128{1} << bits) - 1));
  const mpz_class sum = (mpz_class(static_cast<long>(magnitude >> bits)) << bits) + low;
  return value < 0 ? mpz_class(-sum) : sum;
}

mpq_class rational(Fraction fraction) {
  mpq_class value(big(fraction.numerator), big(fraction.denominator));
  value.canonicalize();
  return value;
}

Point anyPoint(RandomSource& random, std::int64_t limit) {
  return {static_cast<std::int32_t>(anyInteger(random, limit)), static_cast<std::int32_t>(anyInteger(random, limit))};
}

// A random vector, or one equal to, opposite to, half of, or one unit off `other` or its perpendicular.
Point relatedTo(Point other, RandomSource& random, std::int32_t limit) {
  const Point turned = random.oneIn(2) ? other : perpendicular(other);
  switch (random.below(5)) {
    case 0:
      return turned;
    case 1:
      return -turned;
    case 2:
      return {turned.x / 2, turned.y / 2};
    case 3:
      return {std::clamp(turned.x + 1, -limit, limit), turned.y};
    default:
      return anyPoint(random, limit);
  }
}

TEST(ArithmeticLawsTest, ProductsAreExactAndBilinear) {
  constexpr std::int32_t limit = (1 << 30) - 1;
  forEachCase(kCases, [](RandomSource& random) {
    const Point a = anyPoint(random, limit);
    const Point b = relatedTo(a, random, limit);
    const Point c = anyPoint(random, limit);
    EXPECT_EQ(big(dot(a, c)), mpz_class(a.x) * c.x + mpz_class(a.y) * c.y);
    EXPECT_EQ(big(cross(a, c)), mpz_class(a.x) * c.y - mpz_class(a.y) * c.x);
    EXPECT_EQ(dot(a, b), dot(b, a));
    EXPECT_EQ(cross(a, b), -cross(b, a));
    EXPECT_EQ(cross(a, a), 0);
    EXPECT_EQ(cross(a, b), dot(perpendicular(a), b));
    EXPECT_EQ(dot(-a, b), -dot(a, b));
    EXPECT_EQ(big(dot(a + b, c)), big(dot(a, c)) + big(dot(b, c)));
    EXPECT_EQ(big(cross(a - b, c)), big(cross(a, c)) - big(cross(b, c)));
    const mpz_class dots = big(dot(a, b));
    const mpz_class crosses = big(cross(a, b));
    EXPECT_EQ(mpz_class(dots * dots + crosses * crosses), big(squaredLength(a)) * big(squaredLength(b)));
  });
}

Fraction anyFraction(RandomSource& random) {
  return {anyInteger(random, kLargest), 1 + std::abs(anyInteger(random, kLargest - 1))};
}

// A random fraction, or one equal to `other` in other terms, or one that is nearly equal.
Fraction near(Fraction other, RandomSource& random) {
  const std::int64_t factor = random.between(2, 9);
  const bool small = other.denominator < kLargest / 9 && std::abs(other.numerator) < kLargest / 9;
  switch (random.below(4)) {
    case 0:
      return small ? Fraction{other.numerator * factor, other.denominator * factor} : other;
    case 1:
      return {other.numerator, other.denominator + random.between(0, 1)};
    case 2:
      return {other.numerator + random.between(-1, 1), other.denominator};
    default:
      return anyFraction(random);
  }
}

int signOf(std::strong_ordering order) { return (order > 0) - (order < 0); }

TEST(ArithmeticLawsTest, FractionsAreOrderedLikeRationals) {
  forEachCase(kCases, [](RandomSource& random) {
    const Fraction a = anyFraction(random);
    const Fraction b = near(a, random);
    const Fraction c = near(b, random);
    const int order = cmp(rational(a), rational(b));
    EXPECT_EQ(signOf(a <=> b), (order > 0) - (order < 0));
    EXPECT_EQ(a == b, order == 0);
    EXPECT_EQ(signOf(b <=> a), -signOf(a <=> b));
    EXPECT_EQ(a <=> a, std::strong_ordering::equal);
    std::array sorted{a, b, c};
    std::sort(sorted.begin(), sorted.end());
    EXPECT_LE(sorted[0], sorted[2]);
    EXPECT_LE(rational(sorted[0]), rational(sorted[1]));
    EXPECT_LE(rational(sorted[1]), rational(sorted[2]));
  });
}

TEST(ArithmeticLawsTest, ScalingTruncatesTowardsZero) {
  forEachCase(kCases, [](RandomSource& random) {
    const auto value = static_cast<std::int32_t>(anyInteger(random, (std::int64_t{1} << 31) - 1));
    const std::int64_t denominator = 1 + std::abs(anyInteger(random, kLargest - 1));
    const std::int64_t numerator = anyInteger(random, denominator);
    const mpz_class expected = big(value) * big(numerator) / big(denominator);  // GMP truncates as well
    EXPECT_EQ(big(scaleTruncated(value, {numerator, denominator})), expected);
    EXPECT_EQ(scaleTruncated(-value, {numerator, denominator}), -scaleTruncated(value, {numerator, denominator}));
  });
}

template <class Integer>
void expectDivisions(Integer numerator, Integer denominator) {
  const mpz_class n = big(numerator);
  const mpz_class d = big(denominator);
  const mpz_class floor = big(divideFloor(numerator, denominator));
  EXPECT_LE(mpz_class(floor * d), n);
  EXPECT_GT(mpz_class((floor + 1) * d), n);
  const mpz_class ceiling = big(divideCeiling(numerator, denominator));
  EXPECT_GE(mpz_class(ceiling * d), n);
  EXPECT_LT(mpz_class((ceiling - 1) * d), n);
  const mpz_class rounded = big(divideRounded(numerator, denominator));
  const mpz_class off = abs(n - rounded * d);
  EXPECT_LE(mpz_class(2 * off), d);
  if (2 * off == d) {
    EXPECT_GT(mpz_class(abs(rounded) * d), abs(n)) << "a half is rounded towards zero";
  }
  EXPECT_EQ(divideRounded<Integer>(-numerator, denominator), -divideRounded(numerator, denominator));
  EXPECT_EQ(divideFloor<Integer>(-numerator, denominator), -divideCeiling(numerator, denominator));
}

TEST(ArithmeticLawsTest, DivisionsRoundAsDefined) {
  forEachCase(kCases, [](RandomSource& random) {
    const std::int64_t denominator = 1 + std::abs(anyInteger(random, kLargest - 1));
    const std::int64_t numerator = anyInteger(random, kLargest);
    expectDivisions(numerator, denominator);
    expectDivisions(int128{numerator} * anyInteger(random, kLargest), int128{denominator});
    const std::int64_t halves = random.between(-1000, 1000);
    expectDivisions(halves * random.between(1, 9), 2 * random.between(1, 9));
  });
}

TEST(ArithmeticLawsTest, TheSquareRootIsRoundedDown) {
  forEachCase(kCases / 5, [](RandomSource& random) {
    const int128 root = std::abs(anyInteger(random, kLargest - 1));
    for (const int128 value : {root * root - 1, root * root, root * root + random.between(0, 1) * root}) {
      if (value < 0) continue;
      const mpz_class found = big(squareRootFloor(value));
      EXPECT_LE(mpz_class(found * found), big(value));
      EXPECT_GT(mpz_class((found + 1) * (found + 1)), big(value));
    }
  });
}

TEST(ArithmeticLawsTest, AnglesFormAGroup) {
  forEachCase(kCases, [](RandomSource& random) {
    constexpr std::int64_t limit = (1 << 30) - 1;
    const auto wide = static_cast<std::int32_t>(anyInteger(random, limit));
    const auto other = static_cast<std::int32_t>(anyInteger(random, limit));
    const Angle a(wide);
    const Angle b(other);
    const Angle c(static_cast<std::int32_t>(random.between(0, Angle::kTurn)));
    EXPECT_GE(a.centidegrees(), 0);
    EXPECT_LT(a.centidegrees(), Angle::kTurn);
    EXPECT_EQ((wide - a.centidegrees()) % Angle::kTurn, 0);
    EXPECT_EQ(a + b, Angle(wide + other));
    EXPECT_EQ(a - b, Angle(wide - other));
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ(a + (-a), Angle());
    EXPECT_EQ(a - b, a + (-b));
  });
}

// Positions on a face are below 2^26.
TEST(ArithmeticLawsTest, RotatingThereAndBackIsWithinOneSubunit) {
  forEachCase(kCases, [](RandomSource& random) {
    const Point point = anyPoint(random, (1 << 26) - 1);
    const Angle angle(static_cast<std::int32_t>(random.between(0, Angle::kTurn - 1)));
    const Point back = rotate(rotate(point, angle), -angle);
    EXPECT_LE(std::abs(back.x - point.x), 1);
    EXPECT_LE(std::abs(back.y - point.y), 1);
  });
}

TEST(ArithmeticLawsTest, QuarterTurnsAreExactAndCommuteWithRotations) {
  forEachCase(kCases, [](RandomSource& random) {
    const Point point = anyPoint(random, kCoordinateLimit - 1);
    const Angle angle(static_cast<std::int32_t>(random.between(0, Angle::kTurn - 1)));
    EXPECT_EQ(rotate(point, Angle::degrees(90)), perpendicular(point));
    EXPECT_EQ(rotate(point, Angle::degrees(180)), -point);
    EXPECT_EQ(rotate(point, Angle::degrees(270)), -perpendicular(point));
    EXPECT_EQ(rotate(perpendicular(point), angle), perpendicular(rotate(point, angle)));
    EXPECT_EQ(rotate(point, angle + Angle::degrees(90)), perpendicular(rotate(point, angle)));
  });
}

}  // namespace
}  // namespace platon::properties::arithmetic_laws_test
