#include "platon/exact/fraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tests/sim/seeded_random.h"

namespace platon::fraction_test {
namespace {

constexpr std::uint64_t kSeed = 7001;
constexpr std::int64_t kHuge = (std::int64_t{1} << 62) - 1;

// Comparison by continued fractions in 64 bits: integer parts first, then the reciprocals of the remainders.
std::strong_ordering compared(Fraction a, Fraction b) {
  const std::int64_t wholeA = divideFloor(a.numerator, a.denominator);
  const std::int64_t wholeB = divideFloor(b.numerator, b.denominator);
  if (wholeA != wholeB) return wholeA <=> wholeB;
  const std::int64_t restA = a.numerator - wholeA * a.denominator;
  const std::int64_t restB = b.numerator - wholeB * b.denominator;
  if (restA == 0 || restB == 0) return restA <=> restB;
  return compared({b.denominator, restB}, {a.denominator, restA});
}

std::int64_t randomBelow(sim::SeededRandom& random, int bits) {
  return static_cast<std::int64_t>(random.next() >> (64 - bits));
}

TEST(FractionTest, ComparesByValue) {
  EXPECT_EQ((Fraction{1, 2}), (Fraction{2, 4}));
  EXPECT_EQ((Fraction{0, 1}), (Fraction{0, kHuge}));
  EXPECT_EQ((Fraction{-3, 9}), (Fraction{-1, 3}));
  EXPECT_LT((Fraction{-1, 2}), (Fraction{1, 3}));
  EXPECT_LT((Fraction{1, 3}), (Fraction{1, 2}));
  EXPECT_GT((Fraction{-1, 3}), (Fraction{-1, 2}));
  EXPECT_EQ(Fraction(), (Fraction{0, 7}));
}

TEST(FractionTest, DistinguishesNeighboursNear2To62) {
  EXPECT_LT((Fraction{kHuge - 2, kHuge - 1}), (Fraction{kHuge - 1, kHuge}));
  EXPECT_LT((Fraction{kHuge - 1, kHuge}), (Fraction{1, 1}));
  EXPECT_EQ((Fraction{kHuge, kHuge}), (Fraction{1, 1}));
  EXPECT_GT((Fraction{kHuge, kHuge - 1}), (Fraction{1, 1}));
  EXPECT_LT((Fraction{1, kHuge}), (Fraction{1, kHuge - 1}));
  EXPECT_LT((Fraction{-1, kHuge - 1}), (Fraction{-1, kHuge}));
  EXPECT_LT((Fraction{-kHuge, 1}), (Fraction{-kHuge + 1, 1}));
  EXPECT_LT((Fraction{0, 1}), (Fraction{1, kHuge}));
}

TEST(FractionTest, AgreesWithContinuedFractions) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 200000; ++i) {
    const int bits = 2 + i % 61;
    const Fraction a{randomBelow(random, bits) - randomBelow(random, bits), 1 + randomBelow(random, bits)};
    Fraction b{randomBelow(random, bits) - randomBelow(random, bits), 1 + randomBelow(random, bits)};
    if (i % 3 == 0) b = {a.numerator + (i % 2), a.denominator + (i % 5)};
    ASSERT_EQ(a <=> b, compared(a, b)) << "seed " << kSeed << ", round " << i;
    ASSERT_EQ(a == b, compared(a, b) == 0) << "seed " << kSeed << ", round " << i;
    ASSERT_EQ(b <=> a, compared(b, a)) << "seed " << kSeed << ", round " << i;
  }
}

TEST(FractionTest, IsATotalOrder) {
  sim::SeededRandom random(kSeed);
  std::vector<Fraction> fractions;
  for (int i = 0; i < 300; ++i) fractions.push_back({randomBelow(random, 4) - 8, 1 + randomBelow(random, 4)});
  std::sort(fractions.begin(), fractions.end());
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    for (std::size_t j = i; j < fractions.size(); ++j) ASSERT_LE(fractions[i], fractions[j]);
  }
}

TEST(ScaleTruncatedTest, RoundsTowardsZero) {
  EXPECT_EQ(scaleTruncated(7, {1, 2}), 3);
  EXPECT_EQ(scaleTruncated(-7, {1, 2}), -3);
  EXPECT_EQ(scaleTruncated(7, {-1, 2}), -3);
  EXPECT_EQ(scaleTruncated(5, {0, 3}), 0);
  EXPECT_EQ(scaleTruncated(INT32_MAX, {kHuge, kHuge}), INT32_MAX);
  EXPECT_EQ(scaleTruncated(INT32_MIN, {1, 1}), INT32_MIN);
  EXPECT_EQ(scaleTruncated(1 << 30, {kHuge - 1, kHuge}), (1 << 30) - 1);
}

TEST(ScaleTruncatedTest, TruncatesTheExactProduct) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 100000; ++i) {
    const auto denominator = 1 + randomBelow(random, 1 + i % 62);
    const auto numerator = randomBelow(random, 62) % (denominator + 1);
    const auto value = static_cast<std::int32_t>(randomBelow(random, 31)) * (i % 2 == 0 ? 1 : -1);
    const std::int64_t scaled = scaleTruncated(value, {numerator, denominator});
    const int128 remainder = int128{value} * numerator - int128{scaled} * denominator;
    ASSERT_LT(remainder < 0 ? -remainder : remainder, denominator) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::abs(scaled), std::abs(std::int64_t{value}));
    ASSERT_TRUE(remainder == 0 || (remainder > 0) == (value > 0)) << "seed " << kSeed << ", round " << i;
  }
}

}  // namespace
}  // namespace platon::fraction_test
