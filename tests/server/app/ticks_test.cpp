#include "server/app/ticks.h"

#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon::ticks_test {
namespace {

using namespace std::chrono_literals;

using std::chrono::microseconds;

TEST(TickTimes, StartEmpty) {
  const TickTimes times;
  EXPECT_EQ(times.count(), 0u);
  EXPECT_EQ(times.quantile(0.99), 0u);
  EXPECT_EQ(times.longest(), 0u);
}

TEST(TickTimes, ShortDurationsAreExact) {
  TickTimes times;
  for (int i = 1; i <= 31; ++i) times.add(microseconds(i));
  EXPECT_EQ(times.quantile(0), 1u);
  EXPECT_EQ(times.quantile(1.0 / 31), 1u);
  EXPECT_EQ(times.quantile(0.5), 16u);
  EXPECT_EQ(times.quantile(1), 31u);
}

TEST(TickTimes, QuantilesAreRoundedUpByASixteenthAtMost) {
  for (std::uint64_t time = 1; time < 1'000'000; time += time / 50 + 1) {
    TickTimes times;
    times.add(microseconds(time));
    times.add(microseconds(999'999));
    EXPECT_GE(times.quantile(0.5), time);
    EXPECT_LE(times.quantile(0.5), time + time / 16);
  }
}

TEST(TickTimes, TheNinetyNinthPercentileIgnoresOneInAHundred) {
  TickTimes times;
  for (int i = 0; i < 99; ++i) times.add(microseconds(10));
  times.add(microseconds(5000));
  EXPECT_EQ(times.quantile(0.99), 10u);
  EXPECT_EQ(times.quantile(0.995), 5000u);
  EXPECT_EQ(times.longest(), 5000u);
  times.add(microseconds(5000));
  EXPECT_EQ(times.quantile(0.99), 5000u);
}

TEST(TickTimes, TheLongestIsAlwaysExact) {
  TickTimes times;
  times.add(std::chrono::seconds(7));
  EXPECT_EQ(times.longest(), 7'000'000u);
  EXPECT_EQ(times.quantile(1), 1'048'575u);
  times.add(std::chrono::nanoseconds(-5));  // a monotonic clock never gives this
  EXPECT_EQ(times.quantile(0.5), 0u);
  EXPECT_EQ(times.count(), 2u);
}

TEST(TickTimes, TheSumIsThatOfAllDurations) {
  TickTimes times;
  for (const int time : {3, 1000, 2'000'000}) times.add(microseconds(time));
  EXPECT_EQ(times.sum(), 2'001'003u);
}

TEST(TickTimes, AddingAnotherHistogramIsAddingItsDurations) {
  TickTimes one, two, all;
  for (int i = 0; i < 100; ++i) {
    (i % 3 == 0 ? one : two).add(microseconds(i * i));
    all.add(microseconds(i * i));
  }
  one.add(two);
  EXPECT_EQ(one.count(), all.count());
  EXPECT_EQ(one.sum(), all.sum());
  EXPECT_EQ(one.longest(), all.longest());
  for (const double share : {0.1, 0.5, 0.9, 1.0}) EXPECT_EQ(one.quantile(share), all.quantile(share));
}

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
}  // namespace platon::ticks_test
