#include "server/app/tick_clock.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

using namespace std::chrono_literals;

const TimePoint kStart{1h};

TEST(TickClock, HasSixtyTicksASecondWithoutDrift) {
  TickClock clock(kStart);
  std::uint64_t ticks = 0;
  for (auto now = kStart; now <= kStart + 100s; now += 1ms) ticks += clock.take(now) ? 1 : 0;
  EXPECT_EQ(ticks, 6000u);
}

TEST(TickClock, ATickIsDueExactlyAtNext) {
  TickClock clock(kStart);
  EXPECT_FALSE(clock.take(clock.next() - 1ns));
  EXPECT_TRUE(clock.take(clock.next()));
}

TEST(TickClock, MakesUpForAShortPauseAndSkipsTheTicksOfALongOne) {
  TickClock clock(kStart);
  const auto count = [&clock](TimePoint now) {
    int ticks = 0;
    while (clock.take(now)) ++ticks;
    return ticks;
  };
  EXPECT_EQ(count(kStart + 200ms), 12);
  EXPECT_EQ(count(kStart + 60s), 1);
  EXPECT_EQ(count(kStart + 60s + 17ms), 1);
}

}  // namespace
}  // namespace platon
