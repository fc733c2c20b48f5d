#include "server/match/match_client.h"

#include <gtest/gtest.h>

#include <variant>

#include "tests/support/test_levels.h"

namespace platon::match_client_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

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

TEST(InputArrival, WithoutAMessageThereIsNoReport) {
  InputArrival arrival;
  EXPECT_FALSE(arrival.take());
  arrival.count(5);
  const auto report = arrival.take();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->sequence, 5);
  EXPECT_FALSE(report->slack) << "no input has come";
  EXPECT_FALSE(arrival.take());
}

TEST(InputArrival, TheSmallestSlackSinceTheLastReportIsReported) {
  InputArrival arrival;
  for (const SlackReport slack : {SlackReport{10, 1}, {11, -3}, {12, -3}, {13, 4}}) arrival.note(slack);
  EXPECT_EQ(arrival.take()->slack, (SlackReport{11, -3}));
  arrival.note({14, 7});
  EXPECT_EQ(arrival.take()->slack, (SlackReport{14, 7}));
}

TEST(InputArrival, LossIsMeasuredOnSequenceNumbers) {
  InputArrival arrival;
  arrival.count(5);
  arrival.count(7);
  const auto report = arrival.take();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->lostPercent, 33);
  EXPECT_EQ(report->sequence, 7);
}

TEST(InputArrival, ARoundBeginsWithoutWhatArrivedOfTheLast) {
  InputArrival arrival;
  arrival.count(5);
  arrival.note({100, -9});
  arrival.startRound();
  EXPECT_FALSE(arrival.take());
}

class MatchClientTest : public testing::Test {
 protected:
  MatchPlayer& add(std::uint32_t local, std::uint32_t slot, std::uint64_t now = 0) {
    return client_.players().emplace(local, MatchPlayer(slot, "P", now)).first->second;
  }
  // One input of the first player, and one of the companion with this local number.
  static PlayerInputs inputsOf(std::uint32_t local, std::uint32_t first, int buttons) {
    return {1, 0, 0, 0, 10, {pressing(buttons)}, 5, {{local, first, {pressing(buttons)}}}};
  }
  // Number of level texts among the messages of all transfers.
  std::uint32_t takeLevels() {
    std::uint32_t levels = 0;
    for (auto chunk = client_.transfers().nextChunk(); chunk; chunk = client_.transfers().nextChunk()) {
      levels += std::holds_alternative<LevelChunk>(*decodeToClient(*chunk)) ? 1 : 0;
    }
    return levels;
  }

  MatchClient client_{SessionToken{1, 2, 3}, {0, "Ann", 0}};
};

TEST_F(MatchClientTest, KnowsThePlayersByLocalNumberAndBySlot) {
  add(3, 7);
  EXPECT_EQ(client_.slots(), (SlotsByLocal{0, std::nullopt, std::nullopt, 7}));
  EXPECT_EQ(client_.player(0), &client_.first());
  EXPECT_EQ(client_.player(3)->slot(), 7u);
  EXPECT_EQ(client_.player(1), nullptr);
  EXPECT_EQ(client_.player(255), nullptr);
  EXPECT_EQ(client_.localIn(7), 3u);
  EXPECT_EQ(client_.localIn(0), 0u);
  EXPECT_EQ(client_.localIn(3), std::nullopt) << "a slot is no local number";
}

TEST_F(MatchClientTest, EachPlayerHasItsOwnInputs) {
  MatchPlayer& companion = add(1, 4);
  PlayerInputs message = inputsOf(1, 2, Input::kLeft);
  message.first = 0;
  message.inputs = {pressing(1), pressing(2), pressing(4)};
  client_.addInputs(message, 0, 0);
  for (const int buttons : {1, 2, 4}) EXPECT_EQ(client_.first().decideInput(), pressing(buttons));
  EXPECT_EQ(companion.decideInput(), Input{});
  EXPECT_EQ(companion.decideInput(), Input{});
  EXPECT_EQ(companion.decideInput(), pressing(Input::kLeft)) << "its first tick is its own";
}

TEST_F(MatchClientTest, InputsForAPlayerThatIsNotThereAreIgnored) {
  MatchPlayer& companion = add(2, 4);
  EXPECT_EQ(client_.addInputs(inputsOf(1, 0, Input::kLeft), 0, 0), 0u);
  EXPECT_EQ(companion.decideInput(), Input{});
  EXPECT_EQ(client_.arrival().take()->slack, (SlackReport{10, 10})) << "that of the first player";
}

TEST_F(MatchClientTest, TheSmallestSlackOfAllPlayersIsReported) {
  add(1, 4);
  client_.addInputs(inputsOf(1, 3, 1), 5, 0);
  EXPECT_EQ(client_.arrival().take()->slack, (SlackReport{3, -2}));
  client_.addInputs(inputsOf(1, 30, 2), 15, 0);
  EXPECT_EQ(client_.arrival().take()->slack, (SlackReport{30, 15})) << "the first player's is repeated";
}

TEST_F(MatchClientTest, MissedInputsAreThoseOfAllPlayers) {
  MatchPlayer& companion = add(1, 4);
  client_.addInputs({1, 0, 0, 0, 0, {pressing(1)}, 1, {{1, 0, {pressing(1)}}}}, 0, 0);
  for (int tick = 0; tick < 4; ++tick) {
    client_.first().decideInput();
    companion.decideInput();
  }
  const PlayerInputs late{1, 0, 0, 0, 1, {pressing(2)}, 2, {{1, 1, {pressing(2), pressing(2)}}}};
  EXPECT_EQ(client_.addInputs(late, 4, 0), 3u);
  EXPECT_EQ(client_.first().missedInputs(), 1u);
  EXPECT_EQ(companion.missedInputs(), 2u);
  EXPECT_EQ(client_.addInputs(late, 4, 0), 0u) << "once each";
}

TEST_F(MatchClientTest, EachPlayerIsActiveByItsOwnButtons) {
  constexpr std::uint64_t limit = MatchPlayer::kActiveTicks;
  add(1, 4, 10);
  EXPECT_EQ(client_.activePlayers(limit - 1), 2u);
  EXPECT_EQ(client_.activePlayers(limit + 5), 1u) << "the companion joined later";
  client_.addInputs({1, 0, 0, 0, 0, {pressing(0)}, 1, {{1, 0, {pressing(1)}}}}, 0, 100);
  EXPECT_EQ(client_.activePlayers(limit + 50), 1u);
  EXPECT_FALSE(client_.first().isActive(limit + 50));
  client_.vote(true, 200);
  EXPECT_EQ(client_.activePlayers(limit + 50), 2u) << "who has voted is the first one";
  EXPECT_EQ(client_.activePlayers(limit + 150), 1u) << "and no other";
}

TEST_F(MatchClientTest, CompanionsChangeFourTimesAtOnceAndThenOnceInTwoSeconds) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(client_.mayChangeCompanion(1000));
  EXPECT_FALSE(client_.mayChangeCompanion(1000));
  EXPECT_FALSE(client_.mayChangeCompanion(1000 + 2 * kTicksPerSecond - 1));
  EXPECT_TRUE(client_.mayChangeCompanion(1000 + 2 * kTicksPerSecond));
  EXPECT_FALSE(client_.mayChangeCompanion(1000 + 2 * kTicksPerSecond));
}

TEST_F(MatchClientTest, AWishThatChangesNothingIsAnsweredOnceATick) {
  for (std::uint64_t tick = 0; tick < 3; ++tick) {
    EXPECT_TRUE(client_.shouldAnswer(1, tick));
    EXPECT_FALSE(client_.shouldAnswer(1, tick));
  }
}

TEST_F(MatchClientTest, AMessageBeforeTheLastStateOrAcknowledgementIsNotCurrent) {
  const auto message = [](std::uint8_t sync, std::uint32_t confirmed) {
    return PlayerInputs{1, sync, confirmed, 0, confirmed, {}, 0};
  };
  client_.ticks().acknowledge(20);
  EXPECT_TRUE(client_.isCurrent(message(0, 20)));
  EXPECT_FALSE(client_.isCurrent(message(0, 19)));
  client_.transfers().sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 0);
  client_.ticks().acknowledge(30);
  EXPECT_FALSE(client_.isCurrent(message(0, 30)));
  EXPECT_TRUE(client_.isCurrent(message(1, 30)));
}

TEST_F(MatchClientTest, ANewRoundCancelsTheTransferOfAStateButNotOfALevel) {
  client_.transfers().sendState(Transfer(1, 30, 1, SharedBytes({1, 2, 3})), 0);
  client_.transfers().sendLevel(Transfer(levelOf(farGoalText())));
  client_.startRound();
  EXPECT_EQ(takeLevels(), 1u);
  EXPECT_FALSE(client_.ticks().started());
}

TEST_F(MatchClientTest, ARoundStartsForAllPlayers) {
  MatchPlayer& companion = add(1, 4);
  for (int tick = 0; tick < 20; ++tick) companion.decideInput();
  client_.startRound();
  client_.addInputs(inputsOf(1, 10, 2), 0, 0);
  for (int tick = 0; tick < 10; ++tick) EXPECT_EQ(companion.decideInput(), Input{}) << tick;
  EXPECT_EQ(companion.decideInput(), pressing(2));
}

TEST_F(MatchClientTest, ResumingKeepsPlayersAndTokenAndDiscardsAllElse) {
  MatchPlayer& companion = add(2, 9);
  client_.ticks().acknowledge(20);
  client_.transfers().sendLevel(Transfer(levelOf(farGoalText())));
  client_.arrival().count(5);
  client_.addInputs({1, 0, 0, 0, 0, {pressing(1)}, 5, {{2, 0, {pressing(1)}}}}, 0, 0);
  client_.vote(true, 0);
  client_.resume();
  EXPECT_EQ(client_.slots(), (SlotsByLocal{0, std::nullopt, 9}));
  EXPECT_TRUE(client_.hasToken(SessionToken{1, 2, 3}));
  EXPECT_EQ(client_.ticks().acknowledged(), 0u);
  EXPECT_FALSE(client_.transfers().nextChunk());
  EXPECT_FALSE(client_.arrival().take());
  EXPECT_EQ(client_.first().decideInput(), Input{});
  EXPECT_EQ(companion.decideInput(), Input{});
  EXPECT_FALSE(client_.wishesNext(0));
}

TEST_F(MatchClientTest, ResumingFillsNoBudgetAndLiftsNoBan) {
  for (int i = 0; i < 4; ++i) client_.mayChangeCompanion(0);
  client_.forbidCompanions();
  client_.resume();
  EXPECT_FALSE(client_.mayChangeCompanion(0));
  EXPECT_FALSE(client_.mayAddCompanions());
}

TEST_F(MatchClientTest, OnlyAClientWithATokenCanBeResumed) {
  EXPECT_TRUE(client_.canResume());
  EXPECT_FALSE(client_.hasToken(SessionToken{1, 2, 4}));
  const MatchClient without(std::nullopt, {0, "Ben", 0});
  EXPECT_FALSE(without.canResume());
  EXPECT_FALSE(without.hasToken(SessionToken{}));
}

}  // namespace
}  // namespace platon::match_client_test
