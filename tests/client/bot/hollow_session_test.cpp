#include "client/bot/hollow_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "client/bot/button_presser.h"
#include "client/net/network_conditions.h"
#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon::hollow_session_test {
namespace {

using std::chrono::milliseconds;

constexpr ClientId kClient = 1;
constexpr std::uint8_t kButtons = Input::kPresent - 1;

/// A match with one hollow client, in virtual time.
class HollowSessionTest : public testing::Test {
 protected:
  explicit HollowSessionTest(std::vector<std::shared_ptr<const Level>> levels = {endlessLevel()})
      : match_(LevelRotation(std::move(levels)), MatchSettings{16, "test"}) {}

  void join(const LinkQuality& quality) {
    up_.emplace(quality, 1);
    down_.emplace(quality, 2);
    session_.emplace("hollow", now_, token_);
  }

  // Reliable messages use the same simulated connection, so tests drop messages only after joining.
  void run(Time duration) {
    for (const Time end = now_ + duration; now_ < end; now_ += milliseconds(1)) {
      while ((ticks_ + 1) * 1'000'000 / kTicksPerSecond <= static_cast<std::uint64_t>(now_.count())) tick();
      if (session_) exchangeMessages();
    }
  }

  std::uint32_t events(MatchEvent::Kind kind) {
    std::uint32_t found = 0;
    for (const MatchEvent& event : match_.takeEvents()) found += event.kind == kind ? 1 : 0;
    return found;
  }

  // Buttons of slot 0 as decided by the server, and as chosen by the client, by tick.
  std::vector<std::uint8_t> decided_;
  std::vector<std::uint8_t> pressed_;

  Match match_;
  std::optional<HollowSession> session_;
  std::optional<SessionToken> token_;
  bool dropping_ = false;

 private:
  void tick() {
    ++ticks_;
    match_.tick();
    if (session_ && match_.game().slots() > 0) decided_.push_back(match_.game().player(0).held & kButtons);
    for (const Outgoing& message : match_.takeOutgoing()) {
      if (message.client != kClient || (dropping_ && ++sent_ % 3 == 0)) continue;
      down_->send({message.bytes.begin(), message.bytes.end()}, now_);
    }
  }

  void exchangeMessages() {
    session_->update(now_, [this] {
      pressed_.push_back(presser_.next().buttons);
      return Input{pressed_.back()};
    });
    for (OutgoingMessage& message : session_->takeOutgoing()) up_->send(std::move(message.bytes), now_);
    while (const auto bytes = up_->receive(now_)) match_.receive(kClient, *decodeToServer(*bytes));
    while (const auto bytes = down_->receive(now_)) session_->receive(*bytes, now_);
  }

  Time now_{};
  std::uint64_t ticks_ = 0;
  std::uint32_t sent_ = 0;
  std::optional<NetworkConditions> up_, down_;
  ButtonPresser presser_{7};
};

LinkQuality delayed(double delayMs) {
  LinkQuality quality;
  quality.delayMs = delayMs;
  return quality;
}

TEST_F(HollowSessionTest, ItsInputsArriveInTime) {
  join(delayed(50));
  run(std::chrono::seconds(5));
  decided_.clear();
  run(std::chrono::seconds(5));
  ASSERT_GT(decided_.size(), 290u);
  EXPECT_NE(std::search(pressed_.begin(), pressed_.end(), decided_.begin(), decided_.end()), pressed_.end());
  EXPECT_GT(session_->confirmedTicks(), 570u);
  EXPECT_GT(match_.find(kClient)->ticks().acknowledged() + 12, session_->confirmedTicks());
  EXPECT_EQ(events(MatchEvent::Kind::kDesync), 0u);
  EXPECT_NEAR(session_->linkStatistics().rttMs, 110, 20);
}

TEST_F(HollowSessionTest, KeepsUpUnderLoss) {
  join(delayed(20));
  run(std::chrono::seconds(1));
  dropping_ = true;
  run(std::chrono::seconds(5));
  EXPECT_GT(session_->confirmedTicks(), 330u);
  EXPECT_EQ(events(MatchEvent::Kind::kDesync), 0u);
}

TEST_F(HollowSessionTest, JoinsARunningRound) {
  match_.receive(9, Hello{});
  run(std::chrono::seconds(3));
  join(delayed(20));
  run(std::chrono::seconds(3));
  EXPECT_TRUE(match_.game().player(match_.find(kClient)->first().slot()).present);
  EXPECT_GT(match_.find(kClient)->ticks().acknowledged(), 340u);
  EXPECT_NEAR(session_->confirmedTicks(), 175, 10);  // only ticks since it joined
  EXPECT_EQ(events(MatchEvent::Kind::kDesync), 0u);
}

class HollowRounds : public HollowSessionTest {
 protected:
  HollowRounds() : HollowSessionTest({flatLevel(), cornerLevel()}) {}
};

TEST_F(HollowRounds, PlaysTheNextRound) {
  join(delayed(20));
  run(std::chrono::seconds(1));
  // Another player runs into the goal of the first level.
  match_.receive(9, Hello{});
  const std::uint32_t round = match_.round();
  for (std::uint32_t tick = 60; match_.round() == round && tick < 6000; ++tick) {
    match_.receive(9, PlayerInputs{round, 77, 0, 0, tick, {Input{Input::kPresent | Input::kRight}}});
    run(Time(1'000'000 / kTicksPerSecond));
  }
  ASSERT_EQ(match_.round(), round + 1);
  run(std::chrono::seconds(3));
  const MatchClient& client = *match_.find(kClient);
  ASSERT_LT(client.first().slot(), match_.game().slots());
  EXPECT_TRUE(match_.game().player(client.first().slot()).present);
  EXPECT_GT(client.ticks().acknowledged(), 150u);
  EXPECT_EQ(events(MatchEvent::Kind::kDesync), 0u);
}

TEST_F(HollowSessionTest, ReportsWhyItEnded) {
  HollowSession refused("x", Time(0));
  refused.receive(encode(Refused{RefusalCode::kFull, "server is full"}), Time(0));
  ASSERT_TRUE(refused.ending());
  EXPECT_EQ(refused.ending()->reason, "the server refused this client: server is full");
  HollowSession malformed("x", Time(0));
  malformed.receive(std::vector<std::uint8_t>{1, 2, 3, 4}, Time(0));
  ASSERT_TRUE(malformed.ending());
  EXPECT_EQ(malformed.ending()->reason, "protocol error: malformed message from the server");
}

TEST_F(HollowSessionTest, PlaysOnAfterANotice) {
  join(delayed(5));
  run(std::chrono::seconds(1));
  match_.say("restart at noon");
  run(std::chrono::seconds(1));
  EXPECT_FALSE(session_->ending());
  EXPECT_GT(session_->confirmedTicks(), 100u);
}

TEST_F(HollowSessionTest, ResumesItsPlayerWithItsToken) {
  token_ = SessionToken{7};
  join(delayed(20));
  run(std::chrono::seconds(1));
  const std::uint32_t slot = session_->welcome()->slot;
  match_.disconnect(kClient);
  match_.receive(9, Hello{});
  join(delayed(20));
  run(std::chrono::seconds(1));
  ASSERT_TRUE(session_->welcome());
  EXPECT_EQ(session_->welcome()->slot, slot);
  EXPECT_EQ(events(MatchEvent::Kind::kResumed), 1u);
  EXPECT_GT(match_.find(kClient)->ticks().acknowledged(), 90u);
}

TEST_F(HollowSessionTest, LeaveRemovesThePlayer) {
  join(delayed(5));
  run(std::chrono::seconds(1));
  EXPECT_EQ(match_.players(), 1u);
  session_->leave();
  run(milliseconds(50));
  EXPECT_TRUE(match_.idle());
}

// Only a faulty server sends these states: the messages to it must stay within the limits of the protocol.
TEST_F(HollowSessionTest, LimitsItsInputsAfterAStateOfAnyTick) {
  HollowSession session("x", Time(0));
  session.receive(encode(Welcome{0, 1, 2, 4, kTicksPerSecond, ""}), Time(0));
  session.receive(encode(LevelChunk{2, 1, 0, {'x'}}), Time(0));
  Time now{};
  const auto receiveState = [&](std::uint32_t tick) {
    session.receive(encode(StateChunk{1, tick, 1, 1, 0, {0}}), now);
    ConfirmedTicks ticks;
    ticks.round = 1;
    ticks.from = tick;
    ticks.count = 1;
    session.receive(encode(ticks), now);
    for (int frame = 0; frame < 600; ++frame) {
      now += milliseconds(10);
      session.update(now, [] { return Input(); });
    }
    for (const OutgoingMessage& message : session.takeOutgoing()) {
      EXPECT_TRUE(decodeToServer(message.bytes).has_value()) << tick;
    }
  };
  for (const std::uint32_t tick : {5u, 5000u, 7u, UINT32_MAX - 1, 3u}) receiveState(tick);
}

}  // namespace
}  // namespace platon::hollow_session_test
