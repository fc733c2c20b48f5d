#include "client/netcode/prediction_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "platon/game/game.h"
#include "protocol/limits.h"

namespace platon::prediction_clock_test {
namespace {

using std::chrono::milliseconds;

constexpr Time kStart = std::chrono::seconds(50);

ConfirmedTicks ticks(std::uint32_t from, std::uint32_t count) {
  ConfirmedTicks message;
  message.from = from;
  message.count = count;
  return message;
}

ConfirmedTicks withSlack(std::uint32_t from, std::uint32_t count, SlackReport slack) {
  ConfirmedTicks message = ticks(from, count);
  message.link = LinkReport{0, 0, slack};
  return message;
}

// Gives inputs to all ticks that the clock reaches by `ms`.
void chooseInputs(PredictionClock& clock, std::uint32_t next, int ms) {
  clock.update(milliseconds(ms), next);
  for (; clock.reaches(next); ++next) clock.inputChosen(next);
}

/// A connection to a server whose tick is 0 at kStart: delays messages by `delay` plus at most `jitter` ticks each way.
class Link {
 public:
  Link(double delay, double jitter, std::uint64_t seed) : delay_(delay), jitter_(jitter), random_(seed) {}

  // Lets one tick of time pass, in four frames. The client sends the input of its newest tick.
  void pass(PredictionClock& clock) {
    for (int frame = 0; frame < 4; ++frame) {
      ticks_ += 0.25;
      clock.update(kStart + Time(static_cast<Time::rep>(ticks_ * 1e6 / kTicksPerSecond)), next_);
      for (; clock.reaches(next_); ++next_) clock.inputChosen(next_);
    }
    const double arrival = ticks_ + delay_ + jitter_ * static_cast<double>(random_() >> 11) * 0x1p-53;
    reports_.push_back({arrival + delay_, {next_ - 1, static_cast<std::int32_t>(std::floor(next_ - arrival))}});
    while (!reports_.empty() && reports_.front().due <= ticks_) {
      lastSlack_ = reports_.front().slack.slack;
      clock.receive(withSlack(0, 0, reports_.front().slack), kStart);
      reports_.pop_front();
    }
  }

  void setDelay(double delay) { delay_ = delay; }
  std::int32_t lastSlack() const { return lastSlack_; }

 private:
  struct Report {
    double due;
    SlackReport slack;
  };

  double delay_;
  double jitter_;
  std::mt19937_64 random_;
  double ticks_ = 0;
  std::uint32_t next_ = 0;
  std::deque<Report> reports_;
  std::int32_t lastSlack_ = 0;
};

// A clock that shows `tick` at kStart.
PredictionClock clockAt(double tick) {
  PredictionClock clock(tick);
  clock.receive(ticks(0, 0), kStart);
  return clock;
}

TEST(PredictionClock, RunsWithRealTimeWithoutReports) {
  PredictionClock clock = clockAt(10);
  clock.update(kStart + std::chrono::seconds(3), 0);
  EXPECT_NEAR(clock.tick(), 10 + 3 * kTicksPerSecond, 1e-6);
  EXPECT_EQ(clock.error(), 0);
}

TEST(PredictionClock, SlewsByAtMostTwoPerCent) {
  PredictionClock clock = clockAt(20);
  Link link(5, 0, 1);
  for (int i = 0; i < 400; ++i) link.pass(clock);
  link.setDelay(15);
  for (int i = 0; i < 2000; ++i) {
    const double before = clock.tick();
    link.pass(clock);
    EXPECT_LE(std::abs(clock.tick() - before - 1), PredictionClock::kMaxSlew + 1e-4);
  }
  EXPECT_NEAR(clock.error(), 0, 0.1);
  EXPECT_GE(link.lastSlack(), 1);
  EXPECT_EQ(clock.jumps(), 0u);
}

// The round trip is two seconds.
TEST(PredictionClock, DoesNotOscillateOnALongRoundTrip) {
  PredictionClock clock = clockAt(100);
  Link link(60, 0, 1);
  for (int i = 0; i < 3000; ++i) link.pass(clock);
  const double lead = clock.tick() - 3000;
  EXPECT_NEAR(lead, 60 + PredictionClock::kSpareTicks + 0.5, 1.0);
  for (int i = 0; i < 3000; ++i) {
    link.pass(clock);
    EXPECT_NEAR(clock.tick() - (3001 + i), lead, 0.5);
  }
}

TEST(PredictionClock, LeadCoversDelayJitterAndOneSpareTick) {
  for (const double jitter : {0.0, 2.0, 6.0, 12.0}) {
    PredictionClock clock = clockAt(20);
    Link link(5, jitter, 7);
    for (int i = 0; i < 3000; ++i) link.pass(clock);
    int late = 0;
    double lead = 0;
    for (int i = 0; i < 3000; ++i) {
      link.pass(clock);
      late += link.lastSlack() < 0 ? 1 : 0;
      lead += (clock.tick() - (6001 - 3000 + i)) / 3000;
    }
    EXPECT_LE(late, 30) << "jitter " << jitter;
    EXPECT_NEAR(lead, 5 + jitter + 1.5, 1.0) << "jitter " << jitter;
  }
}

TEST(PredictionClock, JumpsForwardWhileSettling) {
  PredictionClock clock = clockAt(0);
  Link link(8, 0, 1);
  for (int i = 0; i < 60; ++i) link.pass(clock);
  EXPECT_GE(clock.jumps(), 1u);
  EXPECT_LE(clock.jumps(), 2u);
  EXPECT_GE(clock.tick() - 60, 8.9);
}

TEST(PredictionClock, DoesNotSlewBackWhileSettling) {
  PredictionClock clock = clockAt(20);
  Link link(5, 0, 1);
  for (int i = 0; i < 60; ++i) link.pass(clock);
  EXPECT_NEAR(clock.tick(), 60 + 20, 1e-3);
  for (int i = 60; i < 1500; ++i) link.pass(clock);
  EXPECT_LT(clock.tick(), 1500 + 8);
  EXPECT_EQ(clock.jumps(), 0u);
}

TEST(PredictionClock, JumpsWhenItIsASecondOff) {
  PredictionClock clock = clockAt(20);
  Link link(5, 0, 1);
  for (int i = 0; i < 400; ++i) link.pass(clock);
  link.setDelay(80);
  for (int i = 0; i < 400; ++i) link.pass(clock);
  EXPECT_EQ(clock.jumps(), 1u);
  EXPECT_NEAR(clock.error(), 0, 0.5);
}

TEST(PredictionClock, IgnoresReportsOfTicksItNeverPassed) {
  PredictionClock clock = clockAt(10);
  clock.receive(withSlack(0, 0, {5000, -20}), kStart);
  clock.receive(withSlack(0, 0, {3, -20}), kStart);
  clock.update(kStart + std::chrono::seconds(1), 0);
  EXPECT_NEAR(clock.tick(), 10 + kTicksPerSecond, 1e-6);
}

TEST(PredictionClock, StartsWithTheFirstMessageThatIsNoBacklog) {
  PredictionClock clock(6);
  EXPECT_FALSE(clock.reaches(0));
  clock.receive(ticks(0, kMaxTicksPerMessage), milliseconds(0));
  EXPECT_FALSE(clock.running());
  EXPECT_EQ(clock.lead(), 6);
  clock.receive(ticks(240, 10), milliseconds(0));
  ASSERT_TRUE(clock.running());
  EXPECT_EQ(clock.firstInput(), 256u);
  EXPECT_TRUE(clock.reaches(255));
  EXPECT_FALSE(clock.reaches(256));
  clock.update(milliseconds(17), 256);
  EXPECT_TRUE(clock.reaches(256));
}

TEST(PredictionClock, LeadIsRelativeToTheNewestTickReceived) {
  PredictionClock clock(6);
  clock.receive(ticks(0, 10), milliseconds(0));
  chooseInputs(clock, 16, 0);
  clock.update(milliseconds(1000), 16);
  clock.receive(ticks(0, 66), milliseconds(1000));
  EXPECT_EQ(clock.lead(), 6);  // the initial lead until the first slack report
  clock.receive(withSlack(0, 66, {16, 0}), milliseconds(1000));
  EXPECT_NEAR(clock.lead(), 10, 1e-9);
}

// The server reports the last of five inputs chosen together; the slack of the first one is four ticks smaller.
TEST(PredictionClock, AReportCountsForTheOldestInputOfItsBatch) {
  const auto errorAfter = [](std::uint32_t reported) {
    PredictionClock clock(6);
    clock.receive(ticks(0, 10), milliseconds(0));
    chooseInputs(clock, 16, 100);
    clock.receive(withSlack(0, 20, {reported, -3}), milliseconds(100));
    return clock.error();
  };
  EXPECT_NEAR(errorAfter(20) - errorAfter(16), -4, 1e-6);
}

TEST(PredictionClock, IgnoresReportsOfInputsChosenAfterAStall) {
  const auto errorAfter = [](int ms) {
    PredictionClock clock(6);
    clock.receive(ticks(0, 10), milliseconds(0));
    chooseInputs(clock, 16, ms);
    clock.receive(withSlack(0, 20, {16, -9}), milliseconds(ms));
    return clock.error();
  };
  EXPECT_LT(errorAfter(240), -5);
  EXPECT_EQ(errorAfter(260), 0);
}

TEST(PredictionClock, TheLeastDelayedMessageSetsTheClockUntilTheFirstReport) {
  PredictionClock clock(6);
  clock.receive(ticks(0, 10), milliseconds(0));
  clock.update(milliseconds(100), 16);
  EXPECT_FALSE(clock.reaches(22));
  clock.receive(ticks(10, 9), milliseconds(100));  // three ticks more in the same time
  clock.update(milliseconds(100), 22);
  EXPECT_TRUE(clock.reaches(24));
  EXPECT_FALSE(clock.reaches(25));
  clock.inputChosen(22);
  clock.receive(withSlack(0, 19, {22, 5}), milliseconds(100));
  clock.receive(ticks(19, 200), milliseconds(100));
  clock.update(milliseconds(100), 23);
  EXPECT_FALSE(clock.reaches(25));
}

TEST(PredictionClock, InitialLeadIsTheAnswerTimePlusSevenTicks) {
  EXPECT_NEAR(PredictionClock::initialLead(milliseconds(100)), 13, 1e-9);
}

// The tick comes from the server; the sum of tick and lead exceeds 32 bits.
TEST(PredictionClock, AcceptsTicksUpToTheLargest) {
  PredictionClock clock(6);
  clock.receive(ticks(UINT32_MAX - 2, 2), milliseconds(0));
  EXPECT_EQ(clock.firstInput(), UINT32_MAX);
  EXPECT_TRUE(clock.reaches(UINT32_MAX));
  clock.update(milliseconds(100), UINT32_MAX);
  clock.inputChosen(UINT32_MAX);
  clock.receive(withSlack(UINT32_MAX - 2, 2, {UINT32_MAX, 3}), milliseconds(100));
  EXPECT_EQ(clock.slack(), 3);
}

}  // namespace
}  // namespace platon::prediction_clock_test
