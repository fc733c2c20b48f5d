#include "client/time/slewing_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace platon::slewing_clock_test {
namespace {

using std::chrono::milliseconds;

constexpr Time kStart = std::chrono::seconds(50);
constexpr double kSlew = 0.05;
constexpr double kJump = 30;

TEST(SlewingClock, SlewsToItsTargetByAtMostTheGivenShare) {
  for (const double off : {-10.0, 10.0}) {
    SlewingClock clock(100, kStart, kSlew, kJump);
    clock.setTarget(clock.lead() + off);
    EXPECT_NEAR(clock.error(), -off, 1e-9);
    double last = clock.tick();
    for (int ms = 10; ms <= 5000; ms += 10) {
      EXPECT_FALSE(clock.update(kStart + milliseconds(ms)));
      EXPECT_LE(std::abs(clock.tick() - last - 0.6), 0.6 * kSlew + 1e-9);
      last = clock.tick();
    }
    EXPECT_NEAR(clock.error(), 0, 1e-9);  // 10 ticks at 3 per second
    EXPECT_NEAR(clock.tick(), 100 + 300 + off, 1e-6);
    EXPECT_EQ(clock.jumps(), 0u);
  }
}

TEST(SlewingClock, JumpsBeyondTheGivenErrorOrOnRequest) {
  SlewingClock clock(100, kStart, kSlew, kJump);
  clock.setTarget(clock.lead() + 29);
  EXPECT_FALSE(clock.update(kStart));
  EXPECT_EQ(clock.tick(), 100);
  EXPECT_TRUE(clock.update(kStart, true));
  EXPECT_NEAR(clock.tick(), 129, 1e-6);
  clock.setTarget(clock.lead() - 31);
  EXPECT_TRUE(clock.update(kStart));
  EXPECT_NEAR(clock.tick(), 98, 1e-6);
  EXPECT_EQ(clock.jumps(), 2u);
}

TEST(SlewingClock, HoldAtSetsTheClockBackAndItCatchesUp) {
  SlewingClock clock(100, kStart, kSlew, kJump);
  clock.update(kStart + milliseconds(100));
  clock.holdAt(107);
  EXPECT_NEAR(clock.tick(), 106, 1e-9);
  clock.holdAt(104);
  EXPECT_EQ(clock.tick(), 104);
  EXPECT_NEAR(clock.error(), -2, 1e-9);
  clock.update(kStart + milliseconds(200));
  EXPECT_NEAR(clock.tick(), 104 + 6 * (1 + kSlew), 1e-6);
}

}  // namespace
}  // namespace platon::slewing_clock_test
