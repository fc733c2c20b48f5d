#include "server/app/recent_tick_times.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "platon/game/game.h"

namespace platon::recent_tick_times_test {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kTick = std::chrono::nanoseconds(1s) / kTicksPerSecond;

// Whatever the time at which the server starts.
class RecentTickTimesTest : public testing::TestWithParam<std::chrono::seconds> {
 protected:
  const TimePoint start_ = TimePoint(1h) + GetParam();
  RecentTickTimes times_;
};

TEST_P(RecentTickTimesTest, HoldsTheTicksOfTheLastMinuteAndOfAtMostOneMore) {
  std::uint64_t ticks = 0;
  for (TimePoint now = start_; now < start_ + 5min; now += kTick) {
    times_.add(now, 1us);
    const std::uint64_t held = times_.all(now).count();
    EXPECT_GE(held, std::min<std::uint64_t>(++ticks, 60 * kTicksPerSecond));
    EXPECT_LE(held, 120 * kTicksPerSecond + 1);
  }
}

TEST_P(RecentTickTimesTest, ALongTickIsHeldForAMinuteAndForgottenAfterTwo) {
  times_.add(start_, 900us);
  for (TimePoint now = start_ + kTick; now <= start_ + 2min; now += kTick) {
    times_.add(now, 10us);
    if (now <= start_ + 1min) {
      EXPECT_EQ(times_.all(now).longest(), 900u);
    }
  }
  EXPECT_EQ(times_.all(start_ + 2min).longest(), 10u);
  EXPECT_EQ(times_.all(start_ + 2min).quantile(0.99), 10u);
}

TEST_P(RecentTickTimesTest, TheTicksOfAServerThatIsEmptyEndWithTheTime) {
  times_.add(start_, 900us);
  EXPECT_EQ(times_.all(start_ + 59s).longest(), 900u);
  EXPECT_EQ(times_.all(start_ + 2min).count(), 0u);
  EXPECT_EQ(times_.all(start_ + 2min).longest(), 0u);
  EXPECT_EQ(times_.all(start_ + 2min).quantile(0.99), 0u);
}

TEST_P(RecentTickTimesTest, TicksAfterAPauseAreNotMixedWithThoseBefore) {
  times_.add(start_, 900us);
  times_.add(start_ + 2min, 10us);
  EXPECT_EQ(times_.all(start_ + 2min).count(), 1u);
  EXPECT_EQ(times_.all(start_ + 2min).longest(), 10u);
}

INSTANTIATE_TEST_SUITE_P(AnyTime, RecentTickTimesTest, testing::Values(0s, 1s, 31s, 59s));

}  // namespace
}  // namespace platon::recent_tick_times_test
