#include "server/fleet/agones_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace platon::agones_schedule_test {
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

}  // namespace
}  // namespace platon::agones_schedule_test
