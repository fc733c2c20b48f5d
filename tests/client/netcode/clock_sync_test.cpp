#include "client/netcode/clock_sync.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "platon/game/game.h"

namespace platon {
namespace {

constexpr Moment kStart = std::chrono::seconds(50);

// A server `phase` ticks ahead of real time, reached by a line that takes `delay` ticks plus at most `jitter`, and
// answers as late.
class Line {
 public:
  Line(double delay, double jitter, std::uint64_t seed) : delay_(delay), jitter_(jitter), random_(seed) {}

  // One tick of time passes; every tick the client sends the input for its own newest tick.
  void pass(ClockSync& clock) {
    ++ticks_;
    clock.update(kStart + Moment(static_cast<Moment::rep>(ticks_ * 1e6 / kTicksPerSecond)));
    const double arrival = ticks_ + delay_ + jitter_ * static_cast<double>(random_() >> 11) * 0x1p-53;
    const auto tick = static_cast<std::uint32_t>(clock.tick());
    reports_.push_back({arrival + delay_, tick, static_cast<std::int32_t>(std::floor(tick - arrival))});
    while (!reports_.empty() && reports_.front().due <= ticks_) {
      lastSlack_ = reports_.front().slack;
      clock.report(reports_.front().tick, reports_.front().slack);
      reports_.pop_front();
    }
  }

  void setDelay(double delay) { delay_ = delay; }
  std::int32_t lastSlack() const { return lastSlack_; }

 private:
  struct Report {
    double due;
    std::uint32_t tick;
    std::int32_t slack;
  };

  double delay_;
  double jitter_;
  std::mt19937_64 random_;
  double ticks_ = 0;
  std::deque<Report> reports_;
  std::int32_t lastSlack_ = 0;
};

TEST(ClockSync, RunsWithRealTimeWithoutReports) {
  ClockSync clock(10, kStart);
  clock.update(kStart + std::chrono::seconds(3));
  EXPECT_NEAR(clock.tick(), 10 + 3 * kTicksPerSecond, 1e-6);
  EXPECT_EQ(clock.error(), 0);
}

TEST(ClockSync, SlewsByTwoPerCentAtMost) {
  ClockSync clock(20, kStart);
  Line line(5, 0, 1);
  for (int i = 0; i < 400; ++i) line.pass(clock);
  line.setDelay(15);  // ten more, suddenly
  for (int i = 0; i < 2000; ++i) {
    const double before = clock.tick();
    line.pass(clock);
    EXPECT_LE(std::abs(clock.tick() - before - 1), ClockSync::kMaxSlew + 1e-4);
  }
  EXPECT_NEAR(clock.error(), 0, 0.1);
  EXPECT_GE(line.lastSlack(), 1);
  EXPECT_EQ(clock.jumps(), 0u);
}

// Two seconds there and back: what was done long ago is not corrected again and again.
TEST(ClockSync, DoesNotSwingOnALongLine) {
  ClockSync clock(100, kStart);
  Line line(60, 0, 1);
  for (int i = 0; i < 3000; ++i) line.pass(clock);
  const double lead = clock.tick() - 3000;
  EXPECT_NEAR(lead, 60 + ClockSync::kSpareTicks + 0.5, 1.0);
  for (int i = 0; i < 3000; ++i) {
    line.pass(clock);
    EXPECT_NEAR(clock.tick() - (3001 + i), lead, 0.5);
  }
}

TEST(ClockSync, BuffersTheJitterAndOneTickMore) {
  for (const double jitter : {0.0, 2.0, 6.0, 12.0}) {
    ClockSync clock(20, kStart);
    Line line(5, jitter, 7);
    for (int i = 0; i < 3000; ++i) line.pass(clock);
    int late = 0;
    double lead = 0;
    for (int i = 0; i < 3000; ++i) {
      line.pass(clock);
      late += line.lastSlack() < 0 ? 1 : 0;
      lead += (clock.tick() - (6001 - 3000 + i)) / 3000;
    }
    EXPECT_LE(late, 30) << "jitter " << jitter;
    EXPECT_NEAR(lead, 5 + jitter + 1.5, 1.0) << "jitter " << jitter;
  }
}

TEST(ClockSync, JumpsForwardWhileItSettles) {
  ClockSync clock(0, kStart);
  Line line(8, 0, 1);
  for (int i = 0; i < 40; ++i) line.pass(clock);
  EXPECT_GE(clock.jumps(), 1u);
  EXPECT_LE(clock.jumps(), 2u);
  EXPECT_GE(clock.tick() - 40, 8.9);
}

// A lead that turns out too long is no harm; the first few reports do not know how late others will be.
TEST(ClockSync, DoesNotGoBackWhileItSettles) {
  ClockSync clock(20, kStart);
  Line line(5, 0, 1);
  for (int i = 0; i < 60; ++i) line.pass(clock);
  EXPECT_NEAR(clock.tick(), 60 + 20, 1e-3);
  for (int i = 60; i < 1500; ++i) line.pass(clock);
  EXPECT_LT(clock.tick(), 1500 + 8);
  EXPECT_EQ(clock.jumps(), 0u);
}

TEST(ClockSync, ShowsWhatIsExpectedUntilTheFirstReport) {
  ClockSync clock(10, kStart);
  clock.expect(14);
  clock.expect(12);
  clock.update(kStart);
  EXPECT_NEAR(clock.tick(), 14, 1e-6);
  EXPECT_FALSE(clock.reported());
  clock.report(10, 3);
  EXPECT_TRUE(clock.reported());
  clock.expect(30);
  clock.update(kStart);
  EXPECT_NEAR(clock.tick(), 14, 1e-6);
}

TEST(ClockSync, JumpsWhenASecondOff) {
  ClockSync clock(20, kStart);
  Line line(5, 0, 1);
  for (int i = 0; i < 400; ++i) line.pass(clock);
  line.setDelay(80);
  for (int i = 0; i < 400; ++i) line.pass(clock);
  EXPECT_EQ(clock.jumps(), 1u);
  EXPECT_NEAR(clock.error(), 0, 0.5);
}

TEST(ClockSync, IgnoresTicksItNeverHad) {
  ClockSync clock(10, kStart);
  clock.report(5000, -20);
  clock.report(3, -20);
  clock.update(kStart + std::chrono::seconds(1));
  EXPECT_NEAR(clock.tick(), 10 + kTicksPerSecond, 1e-6);
}

}  // namespace
}  // namespace platon
