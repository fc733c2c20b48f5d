#include "server/app/recent_tick_times.h"

#include <gtest/gtest.h>

namespace platon::recent_tick_times_test {
namespace {

using namespace std::chrono_literals;

TEST(RecentTickTimes, HoldsAllTicksUntilThereAreTwiceTheMinimum) {
  RecentTickTimes times;
  for (std::uint64_t tick = 1; tick <= 2 * RecentTickTimes::kMinTicks; ++tick) {
    times.add(1us);
    if (tick % 500 == 0) {
      EXPECT_EQ(times.all().count(), tick);
    }
  }
  times.add(1us);
  EXPECT_EQ(times.all().count(), RecentTickTimes::kMinTicks + 1);
}

TEST(RecentTickTimes, ForgetsALongTick) {
  RecentTickTimes times;
  times.add(900us);
  for (std::uint64_t tick = 0; tick < RecentTickTimes::kMinTicks; ++tick) times.add(10us);
  EXPECT_EQ(times.all().longest(), 900u);
  for (std::uint64_t tick = 0; tick < RecentTickTimes::kMinTicks; ++tick) times.add(10us);
  EXPECT_EQ(times.all().longest(), 10u);
  EXPECT_EQ(times.all().quantile(0.99), 10u);
}

}  // namespace
}  // namespace platon::recent_tick_times_test
