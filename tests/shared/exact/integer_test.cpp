#include "platon/exact/integer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace platon::integer_test {
namespace {

TEST(IntegerTest, FixedIntegerExcludesBool) {
  static_assert(!FixedInteger<bool>);
  static_assert(!FixedInteger<char> && !FixedInteger<wchar_t> && !FixedInteger<float> && !FixedInteger<int128>);
  static_assert(FixedInteger<std::int8_t> && FixedInteger<std::uint8_t> && FixedInteger<std::int16_t>);
  static_assert(FixedInteger<std::uint16_t> && FixedInteger<std::int32_t> && FixedInteger<std::uint32_t>);
  static_assert(FixedInteger<std::int64_t> && FixedInteger<std::uint64_t>);
}

TEST(IntegerTest, CoordinatesAreBelowTheLimit) {
  EXPECT_TRUE(isCoordinate(0));
  EXPECT_TRUE(isCoordinate(536870911));
  EXPECT_FALSE(isCoordinate(536870912));
  EXPECT_TRUE(isCoordinate(-536870911));
  EXPECT_FALSE(isCoordinate(-536870912));
  EXPECT_FALSE(isCoordinate(INT64_MIN));
  EXPECT_FALSE(isCoordinate(INT64_MAX));
}

TEST(IntegerTest, DivisionsRoundAsTheirNamesSay) {
  for (int numerator = -60; numerator <= 60; ++numerator) {
    for (int denominator = 1; denominator <= 13; ++denominator) {
      const double quotient = static_cast<double>(numerator) / denominator;
      EXPECT_EQ(divideRounded(numerator, denominator), std::lround(quotient)) << numerator << "/" << denominator;
      EXPECT_EQ(divideFloor(numerator, denominator), std::floor(quotient)) << numerator << "/" << denominator;
      EXPECT_EQ(divideCeiling(numerator, denominator), std::ceil(quotient)) << numerator << "/" << denominator;
    }
  }
}

TEST(IntegerTest, HalvesAreRoundedAwayFromZero) {
  EXPECT_EQ(divideRounded(5, 2), 3);
  EXPECT_EQ(divideRounded(-5, 2), -3);
  EXPECT_EQ(divideRounded(4, 3), 1);
  EXPECT_EQ(divideRounded<std::int64_t>(-1, std::int64_t{1} << 62), 0);
}

TEST(IntegerTest, ShiftsRoundLikeDivisions) {
  for (std::int64_t value = -200; value <= 200; ++value) {
    EXPECT_EQ(shiftRounded<1>(value), divideRounded<std::int64_t>(value, 2)) << value;
    EXPECT_EQ(shiftRounded<4>(value), divideRounded<std::int64_t>(value, 16)) << value;
  }
  constexpr std::int64_t huge = (std::int64_t{1} << 62) - 1;
  EXPECT_EQ(shiftRounded<61>(huge), 2);
  EXPECT_EQ(shiftRounded<61>(-huge), -2);
}

TEST(IntegerTest, ScalingTruncatesTheExactProduct) {
  EXPECT_EQ(scaleTruncated(7, 3, 2), 10);
  EXPECT_EQ(scaleTruncated(-7, 3, 2), -10);
  constexpr std::int64_t huge = (std::int64_t{1} << 62) - 1;
  EXPECT_EQ(scaleTruncated(huge, huge, huge), huge) << "the product needs 124 bits";
  EXPECT_EQ(scaleTruncated(-huge, huge - 1, huge), 1 - huge);
}

TEST(IntegerTest, DividesLargeNumbers) {
  constexpr std::int64_t huge = std::int64_t{1} << 62;
  EXPECT_EQ(divideRounded(huge, huge), 1);
  EXPECT_EQ(divideRounded(-huge, huge), -1);
  EXPECT_EQ(divideFloor(-huge - 1, huge), -2);
  EXPECT_EQ(divideCeiling(huge + 1, huge), 2);
  EXPECT_EQ(divideRounded(int128{huge} * 7, int128{14}), int128{huge} / 2);
}

}  // namespace
}  // namespace platon::integer_test
