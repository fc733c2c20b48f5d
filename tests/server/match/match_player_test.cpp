#include "server/match/match_player.h"

#include <gtest/gtest.h>

#include <variant>

#include "tests/support/test_levels.h"

namespace platon::match_player_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

void receive(MatchPlayer& player, const PlayerInputs& message, std::uint32_t decided) {
  player.countMessage(message.sequence);
  player.addInputs(message, decided, 0);
}

class MatchPlayerTest : public testing::Test {
 protected:
  std::optional<SlackReport> takeSlack() {
    const auto report = player_.takeLinkReport();
    return report ? report->slack : std::nullopt;
  }

  // Number of level texts among the messages of all transfers.
  std::uint32_t takeLevels() {
    std::uint32_t levels = 0;
    for (auto chunk = player_.nextChunk(); chunk; chunk = player_.nextChunk()) {
      levels += std::holds_alternative<LevelChunk>(*decodeToClient(*chunk)) ? 1 : 0;
    }
    return levels;
  }

  MatchPlayer player_{0, "Ann", SessionToken{1, 2, 3}, 0};
};

// One message in four starts at the first unacknowledged tick, the others eight ticks before the end.
TEST_F(MatchPlayerTest, EveryFourthMessageRepeatsAllUnacknowledgedTicks) {
  player_.acknowledge(100);
  std::vector<std::uint32_t> starts;
  for (int message = 0; message < 5; ++message) {
    starts.push_back(player_.nextTickToSend(140, 1));
    player_.ticksSent(starts.back(), 140, 140);
  }
  EXPECT_EQ(starts, (std::vector<std::uint32_t>{100, 132, 132, 132, 100}));
  player_.acknowledge(135);
  EXPECT_EQ(player_.nextTickToSend(140, 1), 135u);
  EXPECT_EQ(player_.nextTickToSend(3, 1), 135u);
}

// The rarer the messages, the more ticks each repeats: a tick is in four messages at least.
TEST_F(MatchPlayerTest, RareMessagesRepeatMoreTicks) {
  player_.acknowledge(100);
  player_.ticksSent(100, 140, 140);
  EXPECT_EQ(player_.nextTickToSend(140, 1), 132u);
  EXPECT_EQ(player_.nextTickToSend(140, 2), 132u);
  EXPECT_EQ(player_.nextTickToSend(140, 3), 128u);
}

TEST_F(MatchPlayerTest, AMessageContinuesWhereTheLastOneWasFull) {
  player_.acknowledge(100);
  player_.ticksSent(100, 340, 500);
  EXPECT_EQ(player_.nextTickToSend(500, 1), 340u);
  player_.ticksSent(340, 500, 500);
  EXPECT_EQ(player_.nextTickToSend(500, 1), 492u);
}

// Whatever the number of messages in between.
TEST_F(MatchPlayerTest, AllUnacknowledgedTicksAreRepeatedAfterMessagesInParts) {
  for (std::uint32_t parts = 3; parts < 8; ++parts) {
    player_.acknowledge(100 * parts);
    player_.ticksSent(100 * parts, 100 * parts + 1, 100 * parts + 50);
    for (std::uint32_t i = 1; i < parts; ++i) player_.ticksSent(100 * parts + i, 100 * parts + i + 1, 100 * parts + 50);
    player_.ticksSent(100 * parts + parts, 100 * parts + 50, 100 * parts + 50);
    EXPECT_EQ(player_.nextTickToSend(100 * parts + 50, 3), 100 * parts) << parts << " parts";
  }
}

TEST_F(MatchPlayerTest, FallsBehindWhenMessagesHoldFewTicks) {
  player_.ticksSent(100, 105, 200);
  EXPECT_FALSE(player_.fallsBehind(2));
  EXPECT_TRUE(player_.fallsBehind(3));
  player_.ticksSent(105, 200, 200);
  EXPECT_FALSE(player_.fallsBehind(3));
  player_.ticksSent(195, 200, 200);
  EXPECT_FALSE(player_.fallsBehind(3)) << "it held all";
}

// The client acknowledges the first part before the second is sent.
TEST_F(MatchPlayerTest, AMessageContinuesWhereAnAcknowledgedOneWasFull) {
  player_.acknowledge(100);
  player_.ticksSent(100, 102, 150);
  player_.acknowledge(102);
  EXPECT_EQ(player_.nextTickToSend(150, 3), 102u);
}

TEST_F(MatchPlayerTest, WithoutAMessageThereIsNoLinkReport) { EXPECT_FALSE(player_.takeLinkReport()); }

TEST_F(MatchPlayerTest, SlackIsThatOfTheNewestInputWhenNothingChanges) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1), pressing(1), pressing(1)}, 5}, 8);
  EXPECT_EQ(takeSlack(), (SlackReport{12, 4}));
  EXPECT_FALSE(player_.takeLinkReport());
}

TEST_F(MatchPlayerTest, SlackIsThatOfTheOldestNewInputThatChangesTheButtons) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1), pressing(1), pressing(1)}, 5}, 8);
  player_.takeLinkReport();
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
  player_.takeLinkReport();
  receive(player_, {1, 0, 0, 0, 14, {pressing(2), pressing(4)}, 10}, 16);
  const auto report = player_.takeLinkReport();
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->slack);
  EXPECT_EQ(report->sequence, 10);
}

TEST_F(MatchPlayerTest, LossIsMeasuredOnSequenceNumbers) {
  receive(player_, {1, 0, 0, 0, 10, {pressing(1)}, 5}, 8);
  receive(player_, {1, 0, 0, 0, 10, {pressing(1)}, 7}, 8);
  const auto report = player_.takeLinkReport();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->lostPercent, 33);
  EXPECT_EQ(report->sequence, 7);
}

TEST_F(MatchPlayerTest, AMessageBeforeTheLastStateOrAcknowledgementIsNotCurrent) {
  const auto message = [](std::uint8_t sync, std::uint32_t confirmed) {
    return PlayerInputs{1, sync, confirmed, 0, confirmed, {}, 0};
  };
  player_.acknowledge(20);
  EXPECT_TRUE(player_.isCurrent(message(0, 20)));
  EXPECT_FALSE(player_.isCurrent(message(0, 19)));
  player_.sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 30, 0);
  EXPECT_FALSE(player_.isCurrent(message(0, 30)));
  EXPECT_TRUE(player_.isCurrent(message(1, 30)));
}

TEST_F(MatchPlayerTest, StatesAreASecondApart) {
  EXPECT_TRUE(player_.maySendState(0));
  player_.sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 30, 100);
  EXPECT_FALSE(player_.maySendState(159));
  EXPECT_TRUE(player_.maySendState(160));
}

TEST_F(MatchPlayerTest, NumbersOfStatesSkipZero) {
  for (int i = 0; i < 256; ++i) player_.sendState(Transfer(1, 1, player_.nextSync(), SharedBytes({1})), 1, 0);
  const auto chunk = player_.nextChunk();
  ASSERT_TRUE(chunk);
  EXPECT_EQ(std::get<StateChunk>(*decodeToClient(*chunk)).sync, 1);
  EXPECT_FALSE(player_.nextChunk());  // a new state replaces the transfer of the last one
}

TEST_F(MatchPlayerTest, ALevelInTransferIsNotSentTwice) {
  const LevelPointer level = levelOf(farGoalText());
  player_.sendLevel(Transfer(level));
  player_.sendLevel(Transfer(level));
  EXPECT_EQ(takeLevels(), 1u);
}

TEST_F(MatchPlayerTest, LevelsPerRoundAreLimited) {
  const LevelPointer level = levelOf(farGoalText());
  std::uint32_t levels = 0;
  for (std::uint32_t i = 0; i < 2 * MatchPlayer::kMaxLevelsPerRound; ++i) {
    player_.sendLevel(Transfer(level));
    levels += takeLevels();
  }
  EXPECT_EQ(levels, MatchPlayer::kMaxLevelsPerRound);
  player_.startRound();
  player_.sendLevel(Transfer(level));
  EXPECT_EQ(takeLevels(), 1u);
}

TEST_F(MatchPlayerTest, ANewRoundCancelsTheTransferOfAStateButNotOfALevel) {
  player_.sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 30, 0);
  player_.sendLevel(Transfer(levelOf(farGoalText())));
  player_.startRound();
  EXPECT_EQ(takeLevels(), 1u);
  EXPECT_FALSE(player_.started());
}

TEST_F(MatchPlayerTest, ResumingKeepsSlotAndTokenAndDiscardsAllElse) {
  player_.acknowledge(20);
  player_.sendLevel(Transfer(levelOf(farGoalText())));
  receive(player_, {1, 0, 0, 0, 0, {pressing(1)}, 5}, 0);
  player_.resume("Anna");
  EXPECT_EQ(player_.slot(), 0u);
  EXPECT_EQ(player_.name(), "Anna");
  EXPECT_TRUE(player_.hasToken(SessionToken{1, 2, 3}));
  EXPECT_EQ(player_.acknowledged(), 0u);
  EXPECT_FALSE(player_.nextChunk());
  EXPECT_FALSE(player_.takeLinkReport());
  EXPECT_EQ(player_.decideInput(), Input{});
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
