#include "server/match/match_player.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace platon::match_player_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

TEST(InputBuffer, ThePlayerIsAbsentUntilItsFirstInput) {
  InputBuffer buffer(10);
  EXPECT_TRUE(buffer.add(12, pressing(1)));
  EXPECT_EQ(buffer.decide(), Input{});
  EXPECT_EQ(buffer.decide(), Input{});
  EXPECT_EQ(buffer.decide(), pressing(1));
  EXPECT_EQ(buffer.next(), 13u);
  EXPECT_EQ(buffer.missed(), 0u);
}

TEST(InputBuffer, HoldsTheLastInputForASecondAndThenReleasesIt) {
  InputBuffer buffer;
  buffer.add(0, pressing(Input::kRight));
  buffer.decide();
  for (std::uint32_t i = 0; i < InputBuffer::kHoldTicks; ++i) EXPECT_EQ(buffer.decide(), pressing(Input::kRight)) << i;
  EXPECT_EQ(buffer.decide(), pressing(0));
  EXPECT_EQ(buffer.missed(), 0u) << "nothing has come too late";
}

// Ticks without an input counted as missed, though a client sends only every fourth input in which nothing changes.
TEST(InputBuffer, OnlyALateInputThatDiffersIsMissed) {
  InputBuffer buffer;
  buffer.add(0, pressing(Input::kRight));
  for (int i = 0; i < 10; ++i) buffer.decide();
  for (std::uint32_t tick = 0; tick < 8; ++tick) buffer.add(tick, pressing(Input::kRight));
  EXPECT_EQ(buffer.missed(), 0u) << "they have come too late, but were decided as they are";
  for (int i = 0; i < 3; ++i) {
    buffer.add(8, pressing(Input::kLeft));
    buffer.add(9, pressing(Input::kLeft));
    EXPECT_EQ(buffer.missed(), 2u) << "once each";
  }
  for (std::uint32_t i = 0; i < InputBuffer::kWindow; ++i) buffer.decide();
  buffer.add(9, pressing(Input::kJump));
  EXPECT_EQ(buffer.missed(), 2u) << "too old to be compared";
  buffer.add(10, pressing(Input::kJump));
  EXPECT_EQ(buffer.missed(), 3u);
}

TEST(InputBuffer, APlayerThatHasNotAppearedMissesNothing) {
  InputBuffer buffer;
  for (int i = 0; i < 10; ++i) buffer.decide();
  for (std::uint32_t tick = 0; tick < 10; ++tick) buffer.add(tick, pressing(Input::kLeft));
  EXPECT_EQ(buffer.missed(), 0u);
}

TEST(InputBuffer, IgnoresInputsForDecidedKnownAndFarTicks) {
  InputBuffer buffer(5);
  EXPECT_FALSE(buffer.add(4, pressing(1)));
  EXPECT_TRUE(buffer.add(5, pressing(1)));
  EXPECT_FALSE(buffer.add(5, pressing(2)));
  EXPECT_TRUE(buffer.add(5 + InputBuffer::kWindow - 1, pressing(3)));
  EXPECT_FALSE(buffer.add(5 + InputBuffer::kWindow, pressing(4)));
  EXPECT_FALSE(buffer.add(UINT32_MAX, pressing(4)));
  EXPECT_EQ(buffer.decide(), pressing(1));
  EXPECT_FALSE(buffer.add(5, pressing(2)));
}

// Its place in the buffer is that of the next tick, which is still free.
TEST(InputBuffer, AnInputBeyondTheWindowIsNotThatOfTheNextTick) {
  InputBuffer buffer(5);
  EXPECT_FALSE(buffer.add(5 + InputBuffer::kWindow, pressing(4)));
  EXPECT_EQ(buffer.decide(), Input{});
}

// Compares the buffer with an unbounded table, on inputs in random order. A tick without input repeats the one before.
TEST(InputBuffer, DecidesEachTickByItsFirstInputInTime) {
  constexpr std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  InputBuffer buffer;
  std::map<std::uint32_t, Input> table;
  Input last;
  for (std::uint32_t tick = 0; tick < 20000; ++tick) {
    for (int i = 0; i < 2; ++i) {
      const auto target = static_cast<std::uint32_t>(tick + random() % 12);
      const Input input = pressing(static_cast<int>(random() % 32));
      EXPECT_EQ(buffer.add(target, input), table.emplace(target, input).second);
    }
    if (table.contains(tick)) last = table.at(tick);
    ASSERT_EQ(buffer.decide(), last) << "tick " << tick;
  }
}

class MatchPlayerTest : public testing::Test {
 protected:
  // Inputs from tick `first` on, of which `decided` ticks are decided.
  std::optional<SlackReport> add(std::uint32_t first, const std::vector<Input>& inputs, std::uint32_t decided = 0,
                                 std::uint64_t now = 0) {
    return player_.addInputs({first, inputs}, decided, now);
  }

  MatchPlayer player_{0, "Ann", 0};
};

TEST_F(MatchPlayerTest, SlackIsThatOfTheNewestInputWhenNothingChanges) {
  EXPECT_EQ(add(10, {pressing(1), pressing(1), pressing(1)}, 8), (SlackReport{12, 4}));
}

TEST_F(MatchPlayerTest, SlackIsThatOfTheOldestNewInputThatChangesTheButtons) {
  add(10, {pressing(1), pressing(1), pressing(1)}, 8);
  // The message with the change at tick 13 was lost.
  EXPECT_EQ(add(10, {pressing(1), pressing(1), pressing(1), pressing(2), pressing(2)}, 14), (SlackReport{13, -1}));
  EXPECT_EQ(add(15, {pressing(4)}, 14), (SlackReport{15, 1})) << "a change in the first input after the known ones";
}

TEST_F(MatchPlayerTest, SlackIsClamped) {
  EXPECT_EQ(add(100000, {pressing(1)}, 0), (SlackReport{100000, kMaxSlack}));
  EXPECT_EQ(add(100001, {pressing(2)}, 200000), (SlackReport{100001, -kMaxSlack}));
}

TEST_F(MatchPlayerTest, RepeatedInputsHaveNoSlack) {
  EXPECT_TRUE(add(14, {pressing(2), pressing(4)}, 15));
  EXPECT_FALSE(add(14, {pressing(2), pressing(4)}, 16));
  EXPECT_FALSE(add(16, {}, 16)) << "none at all";
}

TEST_F(MatchPlayerTest, ANewRoundBeginsWithoutInputs) {
  add(5, {pressing(1)});
  player_.startRound(3);
  EXPECT_EQ(add(3, {pressing(2)}, 3), (SlackReport{3, 0}));
  EXPECT_EQ(player_.decideInput(), pressing(2));
}

TEST_F(MatchPlayerTest, WhoResumesHoldsTheLastInputAndNoneOfTheOldClientFollows) {
  add(0, {pressing(1), pressing(2)});
  EXPECT_EQ(player_.decideInput(), pressing(1));
  player_.resume();
  EXPECT_EQ(player_.decideInput(), pressing(1));
  EXPECT_TRUE(add(0, {pressing(1), pressing(2)}, 2)) << "they are new again";
}

TEST_F(MatchPlayerTest, IsActiveForAMinuteAfterTheLastChangedButton) {
  const std::uint64_t limit = MatchPlayer::kActiveTicks;
  EXPECT_TRUE(player_.isActive(limit - 1));
  EXPECT_FALSE(player_.isActive(limit));
  add(0, {pressing(0), pressing(0)}, 0, 10);
  EXPECT_FALSE(player_.isActive(limit)) << "no button was pressed";
  add(1, {pressing(0), pressing(1)}, 0, 20);
  EXPECT_TRUE(player_.isActive(20 + limit - 1));
  EXPECT_FALSE(player_.isActive(20 + limit));
  add(1, {pressing(0), pressing(1), pressing(1)}, 0, 30);
  EXPECT_FALSE(player_.isActive(20 + limit)) << "inputs that are repeated or held are no change";
  player_.startRound(0);
  add(0, {pressing(1)}, 0, 40);
  EXPECT_FALSE(player_.isActive(20 + limit)) << "a button may be held from one round to the next";
  add(1, {pressing(0)}, 0, 50);
  EXPECT_TRUE(player_.isActive(50 + limit - 1)) << "a release is a change";
}

}  // namespace
}  // namespace platon::match_player_test
