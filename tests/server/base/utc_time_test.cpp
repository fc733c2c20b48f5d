#include "server/base/utc_time.h"

#include <gtest/gtest.h>

namespace platon::utc_time_test {
namespace {

using namespace std::chrono_literals;

UtcTime at(long long secondsSince1970) { return UtcTime(std::chrono::seconds(secondsSince1970)); }

// The numbers are those of `date -u -d TIME +%s`.
TEST(UtcTime, CountsTheSecondsSince1970) {
  EXPECT_EQ(parseUtcTime("1970-01-01T00:00:00Z"), at(0));
  EXPECT_EQ(parseUtcTime("2026-12-01T18:00:59Z"), at(1796148059));
  EXPECT_EQ(parseUtcTime("2028-02-29"), at(1835395200));
  EXPECT_EQ(parseUtcTime("9999-12-31T23:59:59Z"), at(253402300799));
}

TEST(UtcTime, ADateIsItsMidnight) { EXPECT_EQ(parseUtcTime("2026-12-01"), parseUtcTime("2026-12-01T00:00:00Z")); }

TEST(UtcTime, RefusesEverythingElse) {
  for (const char* text : {"",
                           "2026",
                           "2026-12-1",
                           "2026-13-01",
                           "2026-00-01",
                           "2027-02-29",
                           "2026-12-32",
                           "1969-12-31",
                           "26-12-01",
                           "2026-12-01T18:00:00",
                           "2026-12-01 18:00:00Z",
                           "2026-12-01T24:00:00Z",
                           "2026-12-01T18:60:00Z",
                           "2026-12-01T18:00:60Z",
                           "2026-12-01T18:00:00z",
                           "-026-12-01",
                           "2026-12-01T-1:00:00Z",
                           "2026-12-01Z",
                           " 2026-12-01",
                           "2026-12-01T18:00:00+00:00"}) {
    EXPECT_EQ(parseUtcTime(text), std::nullopt) << text;
  }
}

TEST(UtcTime, FormattingReversesParsing) {
  for (const char* text :
       {"1970-01-01T00:00:00Z", "2026-12-01T18:07:09Z", "2028-02-29T23:59:59Z", "9999-12-31T00:00:00Z"}) {
    EXPECT_EQ(formatUtcTime(*parseUtcTime(text)), text);
  }
}

TEST(Duration, IsANumberAndAUnit) {
  EXPECT_EQ(parseDuration("1s"), 1s);
  EXPECT_EQ(parseDuration("90m"), 90min);
  EXPECT_EQ(parseDuration("2h"), 2h);
  EXPECT_EQ(parseDuration("7d"), 168h);
  EXPECT_EQ(parseDuration("4w"), 672h);
  EXPECT_EQ(parseDuration("3650d"), kMaxDuration);
  for (const char* text : {"", "s", "2", "0h", "-1h", "+1h", "1.5h", "2 h", "h2", "2H", "2hh", "2y", "3651d", "522w",
                           "99999999999999999999s"}) {
    EXPECT_EQ(parseDuration(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace platon::utc_time_test
