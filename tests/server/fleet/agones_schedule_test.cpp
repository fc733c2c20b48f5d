#include "server/fleet/agones_schedule.h"

#include <gtest/gtest.h>

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

  // Lets time pass. The tick loop advances, unless it stalls.
  void run(std::chrono::milliseconds time) {
    for (const TimePoint end = now_ + time; now_ < end; now_ += 100ms) {
      if (!stalls_) ++status_.steps;
      while (const auto call = schedule_.due(status_, now_)) {
        made_.push_back({*call, now_});
        schedule_.made(*call, status_, !fails_, now_);
      }
    }
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

  std::size_t pings() {
    std::size_t count = 0;
    for (const Made& made : made_) count += made.call == Call::kHealth ? 1 : 0;
    made_.clear();
    return count;
  }

  TimePoint now_ = TimePoint(100s);
  AgonesSchedule schedule_{now_};
  FleetStatus status_{0, false, {0, 16}, false};
  bool stalls_ = false;
  bool fails_ = false;
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

TEST_F(AgonesScheduleTest, AStalledTickLoopEndsThePingsUntilItAdvances) {
  run(10s);
  pings();
  stalls_ = true;
  run(2s);
  EXPECT_LE(pings(), 1u);
  run(60s);
  EXPECT_EQ(pings(), 0u);
  stalls_ = false;
  run(100ms);
  EXPECT_EQ(pings(), 1u);
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
  EXPECT_EQ(calls(), std::vector<Call>{Call::kPlayers});
  run(10s);
  EXPECT_EQ(calls().front(), Call::kReady);
  run(60s);
  for (const Call call : calls()) EXPECT_EQ(call, Call::kPlayers);
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
  stalls_ = true;
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
