#include "server/fleet/agones_reporter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>

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

  // The tick loop goes on until the thread has made at least this many calls of a kind.
  bool reaches(Call call, std::size_t calls) {
    return stepUntil([this] { report(); }, [&] { return count(call) >= calls; });
  }

  void report() { reporter_.report(players_ > 0, {players_, 16}); }
  void pass(std::chrono::milliseconds time) { now_ += time; }

  std::mutex mutex_;
  std::vector<Call> calls_;
  std::atomic<bool> fails_{false};
  std::atomic<int> allocations_{0};
  std::uint32_t players_ = 0;
  TimePoint now_{100s};
  AgonesReporter reporter_{[this](Call call, const PlayerCount&) { return send(call); }, [this] { return now_; }};
};

TEST_F(AgonesReporterTest, TellsThatTheServerIsReadyAndAlive) {
  ASSERT_TRUE(reaches(Call::kHealth, 1));
  const std::lock_guard lock(mutex_);
  EXPECT_EQ(calls_.front(), Call::kReady);
}

TEST_F(AgonesReporterTest, OneCallIsMadeAtATime) {
  std::promise<void> open;
  std::atomic<int> made = 0;
  AgonesReporter reporter(
      [&, gate = open.get_future().share()](Call, const PlayerCount&) {
        ++made;
        gate.wait();
        return AgonesAnswer{};
      },
      [this] { return now_; });
  EXPECT_TRUE(stepUntil([&] { reporter.report(true, {1, 16}); }, [&] { return made == 1; }));
  for (int i = 0; i < 100; ++i) reporter.report(true, {1, 16});
  reporter.finish(1ms);
  open.set_value();
  EXPECT_TRUE(reporter.finish(20s));
  EXPECT_EQ(made, 2) << "the end is told next";
}

TEST_F(AgonesReporterTest, ATickLoopThatDoesNotReportGetsNoPings) {
  ASSERT_TRUE(reaches(Call::kPlayers, 1));
  const std::size_t before = count(Call::kHealth);
  pass(60s);
  reporter_.takeEvents();
  EXPECT_EQ(count(Call::kHealth), before);
  EXPECT_TRUE(reaches(Call::kHealth, before + 1));
}

TEST_F(AgonesReporterTest, AFailureIsToldOnceAndSoIsItsEnd) {
  ASSERT_TRUE(reaches(Call::kPlayers, 1));
  EXPECT_TRUE(reporter_.takeEvents().empty());
  fails_ = true;
  players_ = 1;
  // An answer is taken in a later step than its call is made, and the next try counts from there.
  const auto stepOn = [this] {
    pass(100ms);
    report();
  };
  ASSERT_TRUE(stepUntil(stepOn, [this] { return this->count(Call::kAllocate) >= 4; }));
  fails_ = false;
  std::vector<AgonesEvent> events;
  const auto count = [&](const AgonesEvent& event) { return std::count(events.begin(), events.end(), event); };
  ASSERT_TRUE(waitUntil([&] {
    pass(1s);
    report();
    for (const AgonesEvent& event : reporter_.takeEvents()) events.push_back(event);
    return count({Call::kAllocate, ""}) == 1;
  }));
  EXPECT_EQ(count({Call::kAllocate, "gone"}), 1);
}

TEST_F(AgonesReporterTest, AnAllocationOfAnEmptyServerIsNotUndone) {
  players_ = 1;
  ASSERT_TRUE(reaches(Call::kAllocate, 1));
  players_ = 0;
  ASSERT_TRUE(reaches(Call::kGameServer, 1));
  allocations_ = 1;
  ASSERT_TRUE(waitUntil([&] {
    pass(1s);
    report();
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
