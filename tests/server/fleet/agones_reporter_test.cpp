#include "server/fleet/agones_reporter.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/wait_until.h"

namespace platon::agones_reporter_test {
namespace {

using namespace std::chrono_literals;
using Call = AgonesCall;

/// A server and a sidecar in virtual time, with a look at what is due every 100 ms.
class AgonesScheduleTest : public testing::Test {
 protected:
  struct Made {
    Call call;
    TimePoint at;
  };

  // Lets time pass.
  void run(std::chrono::milliseconds time) {
    for (const TimePoint end = now_ + time; now_ < end; now_ += 100ms) {
      while (const auto call = schedule_.due(status_, now_)) {
        made_.push_back({*call, now_});
        schedule_.made(*call, status_, answerTo(*call), now_);
      }
    }
  }

  AgonesAnswer answerTo(Call call) const {
    if (fails_ || call == refused_) return {"gone"};
    return {{}, allocation_};
  }

  // Somebody plays for a while and leaves.
  void leave() {
    status_.playing = true;
    run(10s);
    status_.playing = false;
    calls();
  }

  // The calls since the last call of this, without the pings.
  std::vector<Call> calls() {
    std::vector<Call> all;
    for (const Made& made : made_) {
      if (made.call != Call::kHealth) all.push_back(made.call);
    }
    made_.clear();
    return all;
  }

  // How often the server has said since then that it is ready.
  std::ptrdiff_t returns() {
    const std::vector<Call> all = calls();
    return std::count(all.begin(), all.end(), Call::kReady);
  }

  std::size_t pings() {
    std::size_t count = 0;
    for (const Made& made : made_) count += made.call == Call::kHealth ? 1 : 0;
    made_.clear();
    return count;
  }

  TimePoint now_ = TimePoint(100s);
  AgonesSchedule schedule_{now_};
  FleetStatus status_{false, {0, 16}, false};
  bool fails_ = false;
  std::optional<Call> refused_;
  std::string allocation_ = "2026-11-27T18:00:00.1Z";  // the last one that the sidecar knows
  std::vector<Made> made_;
};

TEST_F(AgonesScheduleTest, ReadyComesBeforeTheFirstPing) {
  run(100ms);
  ASSERT_EQ(made_.size(), 3u);
  EXPECT_EQ(made_[0].call, Call::kReady);
  EXPECT_EQ(made_[1].call, Call::kHealth);
  EXPECT_EQ(made_[2].call, Call::kPlayers);
}

TEST_F(AgonesScheduleTest, APingIsSentEveryTwoSeconds) {
  run(60s);
  EXPECT_EQ(pings(), 30u);
}

TEST_F(AgonesScheduleTest, TheServerIsAllocatedAsLongAsSomebodyPlays) {
  run(10s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kReady, Call::kPlayers}));
  status_.playing = true;
  status_.count.players = 1;
  run(10s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kAllocate, Call::kPlayers}));
  status_.count.players = 2;
  run(10s);
  EXPECT_EQ(calls(), std::vector<Call>{Call::kPlayers});
}

// Somebody may be on the way.
TEST_F(AgonesScheduleTest, AnEmptyServerMayBeRemovedAfterThirtySeconds) {
  status_.playing = true;
  run(10s);
  calls();
  status_.playing = false;
  status_.count.players = 1;
  run(29s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kGameServer, Call::kPlayers}));
  run(10s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kGameServer, Call::kReady, Call::kPlayers}));
  run(60s);
  for (const Call call : calls()) EXPECT_EQ(call, Call::kPlayers);
}

// The allocation 26 s after the last player has left was undone 4 s later.
TEST_F(AgonesScheduleTest, AnAllocationOfAnEmptyServerIsNotUndone) {
  leave();
  run(26s);
  calls();
  allocation_ = "2026-11-27T18:00:30.5Z";
  run(33s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kGameServer, Call::kPlayers}));
  run(2s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kGameServer, Call::kReady}));
}

TEST_F(AgonesScheduleTest, EachAllocationOfAnEmptyServerCountsAnew) {
  leave();
  for (int i = 0; i < 5; ++i) {
    run(29s);
    allocation_ += "1";
    run(1s);
    EXPECT_EQ(returns(), 0);
  }
  run(61s);
  EXPECT_EQ(returns(), 1);
}

// The allocation of a player who has come is none of an empty server.
TEST_F(AgonesScheduleTest, AnAllocationBeforeTheLastPlayerLeftDoesNotDelayTheReturn) {
  status_.playing = true;
  run(10s);
  allocation_ = "2026-11-27T18:00:10.5Z";
  run(10s);
  calls();
  status_.playing = false;
  run(31s);
  EXPECT_EQ(returns(), 1);
}

TEST_F(AgonesScheduleTest, AServerThatCannotSeeItsAllocationsStaysAllocated) {
  leave();
  run(10s);
  fails_ = true;
  calls();
  run(300s);
  EXPECT_EQ(returns(), 0);
  fails_ = false;
  run(10s);
  EXPECT_EQ(returns(), 1) << "it has seen that there was none";
}

TEST_F(AgonesScheduleTest, ALateFirstLookCannotTellWhatCameBefore) {
  leave();
  fails_ = true;
  run(100s);
  fails_ = false;
  run(20s);
  EXPECT_EQ(returns(), 0);
  run(30s);
  EXPECT_EQ(returns(), 1);
}

TEST_F(AgonesScheduleTest, AReturnThatFailedLooksAgain) {
  leave();
  run(29s);
  calls();
  refused_ = Call::kReady;
  run(2s);
  allocation_ = "2026-11-27T18:01:00.5Z";
  refused_.reset();
  calls();
  run(29s);
  EXPECT_EQ(returns(), 0);
}

TEST_F(AgonesScheduleTest, ThePlayersAreToldAgainEveryThirtySeconds) {
  run(29s);
  calls();
  run(30s);
  EXPECT_EQ(calls(), std::vector<Call>{Call::kPlayers});
}

TEST_F(AgonesScheduleTest, NothingButPingsIsToldBeforeReadyHasSucceeded) {
  fails_ = true;
  status_.playing = true;
  run(60s);
  for (const Made& made : made_) EXPECT_TRUE(made.call == Call::kReady || made.call == Call::kHealth);
  fails_ = false;
  calls();
  run(10s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kReady, Call::kAllocate, Call::kPlayers}));
}

TEST_F(AgonesScheduleTest, ThePausesAfterFailuresDouble) {
  fails_ = true;
  run(60s);
  std::vector<std::chrono::milliseconds> pauses;
  TimePoint last{};
  for (const Made& made : made_) {
    if (made.call != Call::kReady) continue;
    if (last != TimePoint{}) pauses.push_back(std::chrono::duration_cast<std::chrono::milliseconds>(made.at - last));
    last = made.at;
  }
  pauses.resize(6);
  EXPECT_EQ(pauses, (std::vector<std::chrono::milliseconds>{500ms, 1s, 2s, 4s, 8s, 8s}));
}

TEST_F(AgonesScheduleTest, FailuresDoNotSlowThePings) {
  fails_ = true;
  run(60s);
  EXPECT_EQ(pings(), 30u);
}

TEST_F(AgonesScheduleTest, ShutdownIsTheLastCall) {
  run(10s);
  calls();
  status_.stopped = true;
  EXPECT_FALSE(schedule_.shutDown());
  run(60s);
  ASSERT_EQ(made_.size(), 1u);
  EXPECT_EQ(made_[0].call, Call::kShutdown);
  EXPECT_TRUE(schedule_.shutDown());
}

TEST_F(AgonesScheduleTest, AFailedShutdownIsTriedAgain) {
  run(1s);
  calls();
  status_.stopped = true;
  fails_ = true;
  run(1s);
  EXPECT_EQ(calls(), (std::vector<Call>{Call::kShutdown, Call::kShutdown}));
  fails_ = false;
  run(2s);
  EXPECT_EQ(calls(), std::vector<Call>{Call::kShutdown});
}

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
