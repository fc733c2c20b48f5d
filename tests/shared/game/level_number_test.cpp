#include "shared/game/level_number.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace platon::level_number_test {
namespace {

constexpr std::int64_t kLimit = 131072;

std::int64_t tenThousandths(const std::string& text) {
  LevelNumber number;
  EXPECT_EQ(parseNumber(text, kLimit, number), NumberFault::kNone) << text;
  return number.tenThousandths;
}

NumberFault faultOf(const std::string& text) {
  LevelNumber number;
  return parseNumber(text, kLimit, number);
}

TEST(LevelNumberTest, ReadsIntegersAndDecimals) {
  EXPECT_EQ(tenThousandths("0"), 0);
  EXPECT_EQ(tenThousandths("-0"), 0);
  EXPECT_EQ(tenThousandths("007"), 70000);
  EXPECT_EQ(tenThousandths("-12.5"), -125000);
  EXPECT_EQ(tenThousandths("0.0001"), 1);
  EXPECT_EQ(tenThousandths("-0.0001"), -1);
  EXPECT_EQ(tenThousandths("1.0000"), 10000);
  EXPECT_EQ(tenThousandths("131072"), 1310720000);
  EXPECT_EQ(tenThousandths("-131072.0000"), -1310720000);
  EXPECT_EQ(tenThousandths(std::string(1000, '0') + "1"), 10000);
}

TEST(LevelNumberTest, RefusesTextThatIsNotANumber) {
  for (const char* text : {"",    "-",    ".",   "-.",  "+1", "--1", "1-", ".5", "5.",   "1.2.3", "1,5",
                           "1e5", "0x10", "nan", "inf", "1 ", " 1",  "1f", "１", "1.-2", "1.+2",  "%"}) {
    EXPECT_EQ(faultOf(text), NumberFault::kNotANumber) << "'" << text << "'";
  }
  EXPECT_EQ(faultOf(std::string("1\0", 2)), NumberFault::kNotANumber);
}

TEST(LevelNumberTest, RefusesAFifthDecimalEvenIfItIsZero) {
  EXPECT_EQ(faultOf("1.00000"), NumberFault::kTooManyDecimals);
  EXPECT_EQ(faultOf("-0.12345"), NumberFault::kTooManyDecimals);
}

TEST(LevelNumberTest, RefusesNumbersAboveTheLimit) {
  for (const std::string text : {"131072.0001", "-131072.0001", "131073", "4294967296", "18446744073709551616"}) {
    EXPECT_EQ(faultOf(text), NumberFault::kTooLarge) << text;
  }
  EXPECT_EQ(faultOf(std::string(5000, '9') + ".9"), NumberFault::kTooLarge);
}

TEST(LevelNumberTest, RoundsToTheNearestSubunit) {
  EXPECT_EQ(LevelNumber{10000}.subunits(), 1024);
  EXPECT_EQ(LevelNumber{5000}.subunits(), 512);
  EXPECT_EQ(LevelNumber{4}.subunits(), 0);  // 0.4096
  EXPECT_EQ(LevelNumber{5}.subunits(), 1);  // 0.512
  EXPECT_EQ(LevelNumber{1310720000}.subunits(), 134217728);
  constexpr unsigned seed = 7;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 100000; ++i) {
    const auto value = static_cast<std::int64_t>(random() % 1310720001);
    const std::int64_t subunits = LevelNumber{value}.subunits();
    ASSERT_LT(std::abs(2 * (value * 1024 - subunits * 10000)), 10000) << value << ", seed " << seed;
    ASSERT_EQ(LevelNumber{-value}.subunits(), -subunits) << value << ", seed " << seed;
  }
}

}  // namespace
}  // namespace platon::level_number_test
