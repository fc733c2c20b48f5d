#include "server/match/match_player.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <variant>

#include "tests/support/test_levels.h"

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

TEST(VoteWish, CountsAtOnceAndEndsWhenItIsTakenBackASecondLater) {
  VoteWish wish;
  EXPECT_FALSE(wish.counts(1000));
  wish.set(true);
  EXPECT_TRUE(wish.counts(1000));
  wish.set(false);
  EXPECT_TRUE(wish.counts(1000 + VoteWish::kMinTicks - 1));
  EXPECT_FALSE(wish.counts(1000 + VoteWish::kMinTicks));
}

TEST(VoteWish, TheLastOfManyWishesCounts) {
  VoteWish wish;
  std::uint64_t changes = 0;
  bool before = false;
  for (std::uint64_t tick = 0; tick < 600; ++tick) {
    for (int i = 0; i < 101; ++i) wish.set(i % 2 == (tick % 2 == 0 ? 0 : 1));
    const bool counts = wish.counts(tick);
    changes += counts != before ? 1 : 0;
    before = counts;
  }
  EXPECT_LE(changes, 600 / VoteWish::kMinTicks);
  EXPECT_GT(changes, 0u);
  wish.set(true);
  EXPECT_TRUE(wish.counts(700));
}

TEST(VoteWish, EndsAtOnceWhenItIsCleared) {
  VoteWish wish;
  wish.set(true);
  EXPECT_TRUE(wish.counts(5));
  wish.clear();
  EXPECT_FALSE(wish.counts(5));
  EXPECT_FALSE(wish.counts(5 + 2 * VoteWish::kMinTicks));
}

void receive(MatchPlayer& player, const PlayerInputs& message, std::uint32_t decided) {
  player.inputs().countMessage(message.sequence);
  player.addInputs(message, decided, 0);
}

class MatchPlayerTest : public testing::Test {
 protected:
  std::optional<SlackReport> takeSlack() {
    const auto report = player_.inputs().takeLinkReport();
    return report ? report->slack : std::nullopt;
  }

  // Number of level texts among the messages of all transfers.
  std::uint32_t takeLevels() {
    std::uint32_t levels = 0;
    for (auto chunk = player_.transfers().nextChunk(); chunk; chunk = player_.transfers().nextChunk()) {
      levels += std::holds_alternative<LevelChunk>(*decodeToClient(*chunk)) ? 1 : 0;
    }
    return levels;
  }

  MatchPlayer player_{0, "Ann", SessionToken{1, 2, 3}, 0};
};

TEST_F(MatchPlayerTest, WithoutAMessageThereIsNoLinkReport) { EXPECT_FALSE(player_.inputs().takeLinkReport()); }

TEST_F(MatchPlayerTest, SlackIsThatOfTheNewestInputWhenNothingChanges) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1), pressing(1), pressing(1)}, 5}, 8);
  EXPECT_EQ(takeSlack(), (SlackReport{12, 4}));
  EXPECT_FALSE(player_.inputs().takeLinkReport());
}

TEST_F(MatchPlayerTest, SlackIsThatOfTheOldestNewInputThatChangesTheButtons) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1), pressing(1), pressing(1)}, 5}, 8);
  player_.inputs().takeLinkReport();
  // The message with the change at tick 13 was lost.
  receive(player_, {1, 0, 0, 0, 10, {pressing(1), pressing(1), pressing(1), pressing(2), pressing(2)}, 7}, 14);
  EXPECT_EQ(takeSlack(), (SlackReport{13, -1}));
  // A change in the first input after the known ones.
  receive(player_, {1, 0, 0, 0, 15, {pressing(4)}, 8}, 14);
  EXPECT_EQ(takeSlack(), (SlackReport{15, 1}));
}

TEST_F(MatchPlayerTest, TheSmallestSlackSinceTheLastReportIsReported) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1)}, 1}, 9);
  receive(player_, {1, 0, 0, 0, 11, {pressing(2)}, 2}, 14);
  receive(player_, {1, 0, 0, 0, 12, {pressing(1)}, 3}, 11);
  EXPECT_EQ(takeSlack(), (SlackReport{11, -3}));
}

TEST_F(MatchPlayerTest, SlackIsClamped) {
  receive(player_, {1, 0, 0, 0, 100000, {pressing(1)}, 1}, 0);
  EXPECT_EQ(takeSlack(), (SlackReport{100000, kMaxSlack}));
}

TEST_F(MatchPlayerTest, RepeatedInputsHaveNoSlack) {
  receive(player_, {1, 0, 0, 0, 14, {pressing(2), pressing(4)}, 9}, 15);
  player_.inputs().takeLinkReport();
  receive(player_, {1, 0, 0, 0, 14, {pressing(2), pressing(4)}, 10}, 16);
  const auto report = player_.inputs().takeLinkReport();
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->slack);
  EXPECT_EQ(report->sequence, 10);
}

TEST_F(MatchPlayerTest, LossIsMeasuredOnSequenceNumbers) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1)}, 5}, 8);
  receive(player_, {1, 0, 0, 0, 10, {pressing(1)}, 7}, 8);
  const auto report = player_.inputs().takeLinkReport();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->lostPercent, 33);
  EXPECT_EQ(report->sequence, 7);
}

TEST_F(MatchPlayerTest, AMessageBeforeTheLastStateOrAcknowledgementIsNotCurrent) {
  const auto message = [](std::uint8_t sync, std::uint32_t confirmed) {
    return PlayerInputs{1, sync, confirmed, 0, confirmed, {}, 0};
  };
  player_.ticks().acknowledge(20);
  EXPECT_TRUE(player_.isCurrent(message(0, 20)));
  EXPECT_FALSE(player_.isCurrent(message(0, 19)));
  player_.transfers().sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 0);
  player_.ticks().acknowledge(30);
  EXPECT_FALSE(player_.isCurrent(message(0, 30)));
  EXPECT_TRUE(player_.isCurrent(message(1, 30)));
}

TEST_F(MatchPlayerTest, ANewRoundCancelsTheTransferOfAStateButNotOfALevel) {
  player_.transfers().sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 0);
  player_.transfers().sendLevel(Transfer(levelOf(farGoalText())));
  player_.startRound();
  EXPECT_EQ(takeLevels(), 1u);
  EXPECT_FALSE(player_.ticks().started());
}

TEST_F(MatchPlayerTest, ResumingKeepsSlotAndTokenAndDiscardsAllElse) {
  player_.ticks().acknowledge(20);
  player_.transfers().sendLevel(Transfer(levelOf(farGoalText())));
  receive(player_, {1, 0, 0, 0, 0, {pressing(1)}, 5}, 0);
  player_.resume("Anna");
  EXPECT_EQ(player_.slot(), 0u);
  EXPECT_EQ(player_.name(), "Anna");
  EXPECT_TRUE(player_.hasToken(SessionToken{1, 2, 3}));
  EXPECT_EQ(player_.ticks().acknowledged(), 0u);
  EXPECT_FALSE(player_.transfers().nextChunk());
  EXPECT_FALSE(player_.inputs().takeLinkReport());
  EXPECT_EQ(player_.inputs().decide(), Input{});
}

TEST_F(MatchPlayerTest, IsActiveForAMinuteAfterTheLastChangedButton) {
  const std::uint64_t limit = MatchPlayer::kActiveTicks;
  EXPECT_TRUE(player_.isActive(limit - 1));
  EXPECT_FALSE(player_.isActive(limit));
  player_.addInputs({1, 0, 0, 0, 0, {pressing(0), pressing(0)}, 5}, 0, 10);
  EXPECT_FALSE(player_.isActive(limit)) << "no button was pressed";
  player_.addInputs({1, 0, 0, 0, 1, {pressing(0), pressing(1)}, 6}, 0, 20);
  EXPECT_TRUE(player_.isActive(20 + limit - 1));
  EXPECT_FALSE(player_.isActive(20 + limit));
  player_.addInputs({1, 0, 0, 0, 1, {pressing(0), pressing(1), pressing(1)}, 7}, 0, 30);
  EXPECT_FALSE(player_.isActive(20 + limit)) << "inputs that are repeated or held are no change";
  player_.startRound();
  player_.addInputs({2, 0, 0, 0, 0, {pressing(1)}, 8}, 0, 40);
  EXPECT_FALSE(player_.isActive(20 + limit)) << "a button may be held from one round to the next";
  player_.addInputs({2, 0, 0, 0, 1, {pressing(0)}, 9}, 0, 50);
  EXPECT_TRUE(player_.isActive(50 + limit - 1)) << "a release is a change";
}

TEST_F(MatchPlayerTest, OnlyAPlayerWithATokenCanBeResumed) {
  EXPECT_TRUE(player_.canResume());
  EXPECT_FALSE(player_.hasToken(SessionToken{1, 2, 4}));
  const MatchPlayer without(0, "Ben", std::nullopt, 0);
  EXPECT_FALSE(without.canResume());
  EXPECT_FALSE(without.hasToken(SessionToken{}));
}

}  // namespace
}  // namespace platon::match_player_test
