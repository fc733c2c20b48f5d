#include <gtest/gtest.h>

#include "server/app/tick_clock.h"
#include "server/net/token_bucket.h"

namespace platon {
namespace {

using namespace std::chrono_literals;

const TimePoint kStart{1h};

TEST(TokenBucket, GivesTheBurstThenTheRate) {
  TokenBucket bucket(10, 3, kStart);
  EXPECT_TRUE(bucket.take(2, kStart));
  EXPECT_TRUE(bucket.take(1, kStart));
  EXPECT_FALSE(bucket.take(1, kStart + 99ms));
  EXPECT_TRUE(bucket.take(1, kStart + 101ms));
  EXPECT_FALSE(bucket.take(4, kStart + 1h));
  EXPECT_TRUE(bucket.take(3, kStart + 1h));
}

TEST(TickClock, KeepsSixtyASecondWithoutDrift) {
  TickClock clock(kStart);
  std::uint64_t ticks = 0;
  for (auto now = kStart; now <= kStart + 100s; now += 1ms) ticks += clock.take(now) ? 1 : 0;
  EXPECT_EQ(ticks, 6000u);
}

TEST(TickClock, SaysWhenTheNextTickIsDue) {
  TickClock clock(kStart);
  EXPECT_FALSE(clock.take(clock.next() - 1ns));
  EXPECT_TRUE(clock.take(clock.next()));
}

TEST(TickClock, CatchesUpAfterAShortPauseOnly) {
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
