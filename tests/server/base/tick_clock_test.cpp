#include "server/base/tick_clock.h"

#include <chrono>

#include <gtest/gtest.h>

namespace platon::tick_clock_test {
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

// Changes of the wall clock would otherwise stop a match or make it run through hours.
TEST(TickClock, IsSteady) { static_assert(TimePoint::clock::is_steady); }

int ticksAt(TickClock& clock, TimePoint now) {
  int ticks = 0;
  while (clock.take(now)) ++ticks;
  return ticks;
}

TEST(TickClock, MakesUpForAShortPause) {
  TickClock clock(kStart);
  EXPECT_EQ(ticksAt(clock, kStart + 200ms), 12);
  EXPECT_EQ(ticksAt(clock, kStart + 450ms), 15) << "a quarter of a second";
  EXPECT_EQ(clock.takeDropped(), 0u);
}

TEST(TickClock, DropsTheTicksOfALongPause) {
  TickClock clock(kStart);
  EXPECT_EQ(ticksAt(clock, kStart + 1s), 15);
  EXPECT_EQ(clock.takeDropped(), 45u);
  EXPECT_EQ(ticksAt(clock, kStart + 3s), 15) << "a stall of two seconds";
  EXPECT_EQ(clock.takeDropped(), 105u);
  EXPECT_EQ(clock.takeDropped(), 0u);
  EXPECT_EQ(ticksAt(clock, kStart + 3s + 16ms), 0);
  EXPECT_EQ(ticksAt(clock, kStart + 3s + 17ms), 1) << "the ticks stay at their times";
  EXPECT_EQ(ticksAt(clock, kStart + 24h), 15);
  EXPECT_EQ(clock.takeDropped(), 60u * (24 * 3600 - 3) - 1 - 15);
}

// A tick is taken exactly when it is due, also after months.
TEST(TickClock, CountsExactly) {
  for (const auto since : {0ns, 1s + 1ns, 3600s * 24 * 200 + 7ns}) {
    TickClock clock(kStart);
    ticksAt(clock, kStart + since);
    clock.takeDropped();
    for (int tick = 0; tick < 100; ++tick) {
      const TimePoint due = clock.next();
      EXPECT_FALSE(clock.take(due - 1ns));
      EXPECT_TRUE(clock.take(due));
    }
    EXPECT_EQ(clock.takeDropped(), 0u);
  }
}

}  // namespace
}  // namespace platon::tick_clock_test
