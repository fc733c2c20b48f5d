#include "client/session/round.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/support/test_levels.h"

namespace platon::round_test {
namespace {

constexpr std::uint32_t kId = 7;
constexpr std::uint32_t kSlot = 0;

// The whole state is in one chunk.
void fill(StateChunk& chunk, std::vector<std::uint8_t> bytes) {
  chunk.total = static_cast<std::uint32_t>(bytes.size());
  chunk.bytes = std::move(bytes);
}

// A server's game in which one other player runs right from the start.
class Server {
 public:
  // Advances to `ticks` and returns the message with the ticks since the last call.
  ConfirmedTicks decide(std::uint32_t ticks) {
    ConfirmedTicks message;
    message.round = kId;
    message.from = ticks_;
    message.count = ticks - ticks_;
    if (changed_) message.changes.push_back({ticks_, 1, running_[1]});
    changed_ = false;
    for (; ticks_ < ticks; ++ticks_) game_.advance(running_);
    message.hash = shortHash(game_.hash());
    return message;
  }

  // The other player presses these buttons from now on.
  void press(std::uint8_t buttons) {
    running_[1] = Input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    changed_ = true;
  }

  StateChunk state(std::uint8_t sync) const {
    StateChunk chunk;
    chunk.round = kId;
    chunk.tick = ticks_;
    chunk.sync = sync;
    fill(chunk, encode(FullState{running_, game_.save()}));
    return chunk;
  }

  std::uint64_t hash() const { return game_.hash(); }

 private:
  Game game_{endlessLevel()};
  std::uint32_t ticks_ = 0;
  std::vector<Input> running_ = {Input{}, Input{Input::kPresent | Input::kRight}};
  bool changed_ = true;
};

class RoundTest : public testing::Test {
 protected:
  // Advances to this time and returns the message to send.
  std::optional<PlayerInputs> update(int ms, Input pressed = {}) {
    now_ = std::chrono::milliseconds(ms);
    round_.advance(now_, [pressed](const Game&, std::uint32_t) { return pressed; });
    return round_.takeMessage(now_);
  }

  Server server_;
  Round round_{kId, endlessLevel(), {kSlot}, 6};
  Time now_{};
};

TEST_F(RoundTest, SendsItsStateBeforeTheFirstTicks) {
  const auto first = update(0);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->round, kId);
  EXPECT_EQ(first->confirmed, 0u);
  EXPECT_TRUE(first->inputs.empty());
  EXPECT_FALSE(update(20).has_value());
  EXPECT_TRUE(update(80).has_value());  // the first may be lost
}

TEST_F(RoundTest, PredictsAheadOfConfirmedTicks) {
  round_.receive(server_.decide(100), now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), 100u);
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  const auto report = update(100, Input{Input::kRight});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(round_.prediction().predictedTicks(), 112u);  // 6 ahead, and 6 ticks in 100 ms
  EXPECT_EQ(report->confirmed, 100u);
  EXPECT_EQ(report->hash, shortHash(server_.hash()));
  EXPECT_EQ(report->first, 106u);  // absent before
  ASSERT_EQ(report->inputs.size(), 6u);
  for (const Input input : report->inputs) EXPECT_EQ(input.buttons, Input::kPresent | Input::kRight);
}

TEST_F(RoundTest, SendsChangesAtOnceElseEveryFourthTick) {
  round_.receive(server_.decide(1), now_);
  std::vector<int> sentAt;
  for (int tick = 1; tick <= 40; ++tick) {
    const Input pressed{tick < 20 ? Input::kLeft : Input::kRight};
    if (update(tick * 1000 / kTicksPerSecond + 1, pressed)) sentAt.push_back(tick);
  }
  for (std::size_t i = 1; i < sentAt.size(); ++i) EXPECT_LE(sentAt[i] - sentAt[i - 1], 4);
  for (const int tick : {20, 21, 22}) {
    EXPECT_EQ(std::count(sentAt.begin(), sentAt.end(), tick), 1) << tick;
  }
  EXPECT_LE(sentAt.size(), 40u / 4 + 2 * 3 + 1);
}

// It leaves and comes back before the next tick.
TEST_F(RoundTest, WhoTakesOverALocalNumberSendsNothingOfTheOneBefore) {
  round_.setSlots({kSlot, 2});
  round_.receive(server_.decide(100), now_);
  const auto before = update(100, Input{Input::kRight});
  ASSERT_EQ(before->companions.size(), 1U);
  const std::uint32_t next = round_.prediction().predictedTicks();
  round_.setSlots({kSlot});
  round_.setSlots({kSlot, 3});
  const auto after = update(140, Input{Input::kLeft});
  ASSERT_EQ(after->companions.size(), 1U);
  EXPECT_EQ(after->companions[0].first, next);
  EXPECT_LT(after->first, next);
}

// The law also holds after the maximum number of predicted ticks.
TEST_F(RoundTest, CallsControlsOncePerTick) {
  round_.receive(server_.decide(10), now_);
  std::uint32_t calls = 0;
  for (int ms = 0; ms < 6000; ms += 10) {
    round_.advance(std::chrono::milliseconds(ms), [&calls](const Game&, std::uint32_t) { return ++calls, Input(); });
  }
  EXPECT_FALSE(round_.prediction().mayPredict());
  EXPECT_EQ(calls, round_.prediction().predictedTicks() - 16);  // absent before
}

TEST_F(RoundTest, IgnoresKnownTicksAndGaps) {
  const ConfirmedTicks first = server_.decide(10);
  const ConfirmedTicks second = server_.decide(20);
  ConfirmedTicks third = server_.decide(30);
  round_.receive(first, now_);
  round_.receive(third, now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), 10u);
  round_.receive(second, now_);
  round_.receive(first, now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), 20u);
  // Only the new ticks of a message are applied.
  third.from = 15;
  third.count = 15;
  round_.receive(third, now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), 30u);
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  EXPECT_EQ(round_.statistics().desyncs, 0u);
}

// A message may begin before the last confirmed tick.
TEST_F(RoundTest, OfTicksThatAreRepeatedOnlyTheLaterChangesAreApplied) {
  ConfirmedTicks first = server_.decide(10);
  round_.receive(first, now_);
  server_.press(Input::kLeft);
  const ConfirmedTicks second = server_.decide(20);
  ConfirmedTicks both = second;
  both.from = 0;
  both.count = 20;
  both.changes = first.changes;
  both.changes.insert(both.changes.end(), second.changes.begin(), second.changes.end());
  ASSERT_EQ(both.changes.size(), 2u);
  round_.receive(both, now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), 20u);
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  EXPECT_EQ(round_.statistics().desyncs, 0u);
}

TEST_F(RoundTest, TheControlsSeeThePredictedGameAndTheOwnSlot) {
  round_.receive(server_.decide(10), now_);
  std::uint32_t calls = 0;
  round_.advance(std::chrono::milliseconds(200), [&](const Game& game, std::uint32_t slot) {
    EXPECT_EQ(&game, &round_.prediction().predicted());
    EXPECT_EQ(slot, kSlot);
    ++calls;
    return Input();
  });
  EXPECT_GT(calls, 0u);
}

TEST_F(RoundTest, ConfirmsOnlyAsManyTicksInAFrameAsOneMayCost) {
  std::vector<ConfirmedTicks> messages;
  for (std::uint32_t end = 200; end <= 6000; end += 200) messages.push_back(server_.decide(end));
  const auto receiveAll = [&] {
    for (const ConfirmedTicks& message : messages) round_.receive(message, now_);
  };
  receiveAll();
  constexpr std::uint32_t kFirst = Round::kMaxWorkConfirmed / 2 + 1;  // two players, but one before the first message
  EXPECT_NEAR(round_.prediction().confirmedTicks(), kFirst, 1);
  receiveAll();
  EXPECT_NEAR(round_.prediction().confirmedTicks(), kFirst, 1);
  while (round_.prediction().confirmedTicks() < 6000) {
    const std::uint32_t before = round_.prediction().confirmedTicks();
    const auto message = update(static_cast<int>(before));
    ASSERT_TRUE(message.has_value());
    ASSERT_EQ(message->confirmed, before);
    ASSERT_EQ(message->hash, shortHash(round_.prediction().confirmed().hash()))
        << "else the server takes it for a desync";
    receiveAll();
    ASSERT_GT(round_.prediction().confirmedTicks(), before);
  }
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  EXPECT_EQ(round_.statistics().desyncs, 0u);
}

TEST_F(RoundTest, ResyncsAfterADesync) {
  ConfirmedTicks wrong = server_.decide(10);
  wrong.changes.clear();  // the other player is missing
  round_.receive(wrong, now_);
  EXPECT_EQ(round_.statistics().desyncs, 1u);
  const auto message = update(60);
  ASSERT_TRUE(message.has_value());
  EXPECT_NE(message->hash, shortHash(server_.hash()));  // shows the desync to the server
  round_.receive(server_.decide(12), now_);
  EXPECT_EQ(round_.statistics().desyncs, 1u);  // the same desync

  round_.receive(server_.state(3));
  EXPECT_EQ(round_.statistics().resyncs, 1u);
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  EXPECT_EQ(round_.prediction().confirmedTicks(), 12u);
  const auto next = update(120);
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->sync, 3);
  EXPECT_EQ(next->hash, shortHash(server_.hash()));
  round_.receive(server_.decide(20), now_);
  EXPECT_EQ(round_.prediction().confirmed().hash(), server_.hash());
  EXPECT_EQ(round_.statistics().desyncs, 1u);
}

// No hash has matched in between.
TEST_F(RoundTest, ADesyncRightAfterAResyncCountsAgainAndIsToldAtOnce) {
  for (std::uint32_t times = 1; times <= 2; ++times) {
    ConfirmedTicks wrong = server_.decide(times * 10);
    wrong.hash ^= 1;
    const int ms = static_cast<int>(times) * 1000;
    update(ms);
    round_.receive(wrong, now_);
    EXPECT_EQ(round_.statistics().desyncs, times);
    EXPECT_TRUE(update(ms + 1).has_value()) << "the server learns of it";
    round_.receive(server_.state(static_cast<std::uint8_t>(times)));
    EXPECT_EQ(round_.statistics().resyncs, times);
    EXPECT_TRUE(round_.takeDesync().has_value());
    EXPECT_FALSE(round_.takeDesync().has_value());
  }
}

TEST_F(RoundTest, TheFirstStateIsNoResync) {
  server_.decide(1000);
  round_.receive(server_.state(1));
  EXPECT_EQ(round_.prediction().confirmedTicks(), 1000u);
  EXPECT_EQ(round_.statistics().resyncs, 0u);
}

TEST_F(RoundTest, OnlyTheLastChunkCompletesAState) {
  server_.decide(10);
  const StateChunk whole = server_.state(1);
  StateChunk part = whole;
  part.bytes.resize(9);
  EXPECT_FALSE(round_.receive(part));
  EXPECT_EQ(round_.prediction().confirmedTicks(), 0u);
  part.offset = 9;
  part.bytes.assign(whole.bytes.begin() + 9, whole.bytes.end());
  EXPECT_TRUE(round_.receive(part));
  EXPECT_EQ(round_.prediction().confirmedTicks(), 10u);
}

TEST_F(RoundTest, MessagesOfAnotherRoundAreIgnored) {
  ConfirmedTicks ticks = server_.decide(10);
  StateChunk state = server_.state(1);
  ticks.round = state.round = kId + 1;
  round_.receive(ticks, now_);
  EXPECT_FALSE(round_.receive(state));
  EXPECT_EQ(round_.prediction().confirmedTicks(), 0u);
  EXPECT_FALSE(round_.clock().running());
}

TEST_F(RoundTest, IgnoresAnInvalidState) {
  round_.receive(server_.decide(10), now_);
  StateChunk invalid = server_.state(1);
  fill(invalid, {2, 128, 128, 9, 9, 9});
  EXPECT_TRUE(round_.receive(invalid)) << "it is complete";
  EXPECT_EQ(round_.prediction().confirmedTicks(), 10u);
  EXPECT_EQ(update(60)->sync, 0);
}

TEST_F(RoundTest, PredictedFractionFollowsTheClock) {
  round_.receive(server_.decide(10), now_);
  update(100);
  EXPECT_NEAR(round_.predictedFraction(), 0, 1e-6);
  update(104);
  EXPECT_NEAR(round_.predictedFraction(), 0.24, 1e-6);
}

TEST_F(RoundTest, TheInterpolationBufferFollowsTheConfirmedGame) {
  round_.receive(server_.decide(10), now_);
  round_.receive(server_.decide(12), now_);
  EXPECT_EQ(round_.interpolationBuffer().newest(), 12u);
  const InterpolatedPlayers players = round_.interpolationBuffer().players();
  ASSERT_EQ(players.now.size(), 2u);
  EXPECT_TRUE(players.now[1].present);
  EXPECT_LT(round_.interpolationBuffer().tick(), 12);
  const double before = round_.interpolationBuffer().tick();
  update(10);
  EXPECT_GT(round_.interpolationBuffer().tick(), before);
}

TEST_F(RoundTest, AFullStateRestartsTheInterpolationBuffer) {
  round_.receive(server_.decide(10), now_);
  server_.decide(30);
  round_.receive(server_.state(1));
  EXPECT_EQ(round_.interpolationBuffer().newest(), 30u);
  EXPECT_EQ(round_.interpolationBuffer().tick(), 30);
  EXPECT_EQ(round_.interpolationBuffer().jumps(), 1u);
}

// The tick of a full state comes from the server, so it may have any value.
TEST_F(RoundTest, AcceptsAStateOfTheLargestTick) {
  StateChunk chunk = server_.state(1);
  chunk.tick = UINT32_MAX - 2;
  round_.receive(chunk);
  ConfirmedTicks last;
  last.round = kId;
  last.from = UINT32_MAX - 2;
  last.count = 1;
  round_.receive(last, now_);
  EXPECT_EQ(round_.prediction().confirmedTicks(), UINT32_MAX - 1);
  for (int ms = 0; ms <= 1000; ms += 10) {
    const auto message = update(ms);
    if (message) {
      EXPECT_TRUE(decodeToServer(encode(*message)).has_value());
    }
  }
  EXPECT_EQ(round_.prediction().predictedTicks(), UINT32_MAX);
}

}  // namespace
}  // namespace platon::round_test
