#include "server/app/log.h"

#include <vector>

#include <gtest/gtest.h>

namespace platon::log_test {
namespace {

TEST(Log, WritesOneLinePerEvent) {
  std::vector<std::string> lines;
  Log log(LogFormat::kText, [&lines](std::string_view line) { lines.emplace_back(line); });
  log.info("listening on 0.0.0.0:7777");
  log.warning("joined", {{"slot", std::uint64_t{3}}, {"name", std::string("a\"b")}});
  EXPECT_EQ(lines, (std::vector<std::string>{"listening on 0.0.0.0:7777", "joined slot=3 name=\"a\\\"b\""}));
}

TEST(Log, WritesJsonWithTheTime) {
  std::string line;
  Log log(LogFormat::kJson, [&line](std::string_view text) { line = text; });
  log.warning("kept \"out\"", {{"count", std::uint64_t{3}}, {"name", std::string("a\nb\\")}});
  const std::string time = R"({"time":")";
  ASSERT_EQ(line.substr(0, time.size()), time);
  EXPECT_EQ(line.substr(time.size() + std::string("2024-01-01T00:00:00.000Z").size()),
            R"(","level":"warning","message":"kept \"out\"","count":3,"name":"a\u000ab\\"})");
}

using std::chrono::minutes;
using std::chrono::seconds;

const TimePoint kBegin{std::chrono::hours(5)};

TEST(BanNotices, OneHouseholdIsToldOfOnceAnHour) {
  BanNotices notices;
  int told = 0;
  for (seconds passed{0}; passed < minutes(180); passed += seconds(1)) told += notices.take(1, kBegin + passed) ? 1 : 0;
  EXPECT_EQ(told, 3);
}

TEST(BanNotices, AHouseholdThatHadToWaitIsToldOfAtItsNextTry) {
  BanNotices notices;
  EXPECT_TRUE(notices.take(1, kBegin));
  EXPECT_FALSE(notices.take(2, kBegin + seconds(9)));
  EXPECT_TRUE(notices.take(2, kBegin + seconds(10)));
  EXPECT_FALSE(notices.take(1, kBegin + seconds(30)));
}

TEST(BanNotices, ManyHouseholdsGiveALineInTenSecondsAndNeedLittleMemory) {
  BanNotices notices;
  std::uint64_t household = 0;
  int told = 0;
  for (seconds passed{0}; passed < minutes(180); passed += seconds(1)) {
    for (int i = 0; i < 10; ++i) told += notices.take(++household, kBegin + passed) ? 1 : 0;
    ASSERT_LE(notices.size(), 360u);
  }
  EXPECT_EQ(told, 3 * 360);
}

}  // namespace
}  // namespace platon::log_test
