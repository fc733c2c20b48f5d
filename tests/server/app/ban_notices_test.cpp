#include "server/app/ban_notices.h"

#include <gtest/gtest.h>

namespace platon::ban_notices_test {
namespace {

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
}  // namespace platon::ban_notices_test
