#include "server/fleet/agones_reporter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "tests/support/wait_until.h"

namespace platon::agones_reporter_test {
namespace {

using namespace std::chrono_literals;
using Call = AgonesCall;

/// A reporter whose calls are counted and whose clock the test moves.
class AgonesReporterTest : public testing::Test {
 protected:
  AgonesAnswer send(Call call) {
    const std::lock_guard lock(mutex_);
    calls_.push_back(call);
    if (fails_) return {"gone"};
    return {{}, "allocation " + std::to_string(allocations_)};
  }

  std::size_t count(Call call) {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count(calls_.begin(), calls_.end(), call));
  }

  // Moves the clock and waits until the thread has looked at it: until it has made at least this many calls of a kind.
  bool reaches(Call call, std::size_t calls) {
    return waitUntil([&] { return count(call) >= calls; });
  }

  void pass(std::chrono::milliseconds time) { now_ += time.count(); }

  std::mutex mutex_;
  std::vector<Call> calls_;
  std::atomic<bool> fails_{false};
  std::atomic<int> allocations_{0};
  std::atomic<std::int64_t> now_{100'000};  // ms
  AgonesReporter reporter_{[this](Call call, const PlayerCount&) { return send(call); },
                           [this] { return TimePoint(std::chrono::milliseconds(now_)); }};
};

TEST_F(AgonesReporterTest, TellsThatTheServerIsReadyAndAlive) {
  ASSERT_TRUE(reaches(Call::kHealth, 1));
  const std::lock_guard lock(mutex_);
  EXPECT_EQ(calls_.front(), Call::kReady);
}

TEST_F(AgonesReporterTest, ATickLoopThatDoesNotReportGetsNoPings) {
  ASSERT_TRUE(reaches(Call::kPlayers, 1));
  const std::size_t before = count(Call::kHealth);
  pass(60s);  // longer than AgonesSchedule::kCountInterval
  ASSERT_TRUE(reaches(Call::kPlayers, 2)) << "the thread goes on";
  EXPECT_EQ(count(Call::kHealth), before);
  reporter_.report(false, {0, 16});
  EXPECT_TRUE(reaches(Call::kHealth, before + 1));
}

TEST_F(AgonesReporterTest, AFailureIsToldOnceAndSoIsItsEnd) {
  ASSERT_TRUE(reaches(Call::kPlayers, 1));
  EXPECT_TRUE(reporter_.takeEvents().empty());
  fails_ = true;
  reporter_.report(true, {1, 16});
  for (std::size_t failures = 1; failures <= 4; ++failures) {
    ASSERT_TRUE(reaches(Call::kAllocate, failures));
    pass(10s);
  }
  fails_ = false;
  reporter_.report(true, {1, 16});
  std::vector<AgonesEvent> events;
  const auto count = [&](const AgonesEvent& event) { return std::count(events.begin(), events.end(), event); };
  ASSERT_TRUE(waitUntil([&] {
    pass(1s);
    for (const AgonesEvent& event : reporter_.takeEvents()) events.push_back(event);
    return count({Call::kAllocate, ""}) == 1;
  }));
  EXPECT_EQ(count({Call::kAllocate, "gone"}), 1);
}

TEST_F(AgonesReporterTest, AnAllocationOfAnEmptyServerIsNotUndone) {
  reporter_.report(true, {1, 16});
  ASSERT_TRUE(reaches(Call::kAllocate, 1));
  reporter_.report(false, {0, 16});
  ASSERT_TRUE(reaches(Call::kGameServer, 1));
  allocations_ = 1;
  ASSERT_TRUE(waitUntil([&] {
    pass(1s);
    return count(Call::kReady) == 2;
  }));
  EXPECT_EQ(count(Call::kGameServer), 3u) << "the second look has found it, and the third one nothing new";
}

TEST_F(AgonesReporterTest, TheEndIsTold) {
  EXPECT_TRUE(reporter_.finish(20s));
  EXPECT_EQ(count(Call::kShutdown), 1u);
}

TEST_F(AgonesReporterTest, ASidecarThatIsGoneDoesNotHoldUpTheEnd) {
  fails_ = true;
  EXPECT_FALSE(reporter_.finish(10ms));
}

}  // namespace
}  // namespace platon::agones_reporter_test
