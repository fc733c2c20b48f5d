#include "protocol/round_trip_code.h"

#include <gtest/gtest.h>

namespace platon::round_trip_code_test {
namespace {

TEST(RoundTripCode, EveryCodeButThatOfNoneIsTheCodeOfItsRoundTrip) {
  EXPECT_FALSE(roundTripOf(kNoRoundTrip));
  for (std::uint32_t code = 1; code <= UINT8_MAX; ++code) {
    const auto ms = roundTripOf(static_cast<std::uint8_t>(code));
    ASSERT_TRUE(ms);
    EXPECT_EQ(codeOfRoundTrip(*ms), code);
  }
}

TEST(RoundTripCode, IsRoundedToTheNearestStep) {
  for (std::uint32_t ms = 0; ms <= kMaxRoundTripMs; ++ms) {
    const auto read = roundTripOf(codeOfRoundTrip(ms));
    ASSERT_TRUE(read);
    EXPECT_LE(*read, ms + kRoundTripStepMs / 2);
    EXPECT_GE(*read + kRoundTripStepMs / 2, ms);
  }
}

TEST(RoundTripCode, ALongerOneIsTheLongest) {
  EXPECT_EQ(kMaxRoundTripMs, 1016u);
  EXPECT_EQ(roundTripOf(codeOfRoundTrip(kMaxRoundTripMs + 1)), kMaxRoundTripMs);
  EXPECT_EQ(codeOfRoundTrip(UINT32_MAX), UINT8_MAX);
}

}  // namespace
}  // namespace platon::round_trip_code_test
