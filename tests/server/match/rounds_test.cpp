// Votes, countdown and what comes next. When a round ends by itself: match_round_end_test.
#include "server/match/rounds.h"

#include <gtest/gtest.h>

#include "server/match/match.h"
#include "tests/server/match/kept_times.h"
#include "tests/support/test_levels.h"

namespace platon::rounds_test {
namespace {

TEST(VotePasses, WithMoreThanHalfOfTheVoters) {
  for (std::uint32_t voters = 0; voters <= kMaxPlayers; ++voters) {
    std::uint32_t fewest = 0;
    while (!votePasses({1, fewest, voters})) ++fewest;
    EXPECT_EQ(fewest, voters / 2 + 1) << voters << " voters";
  }
}

TEST(VoteNotices, NobodyIsToldWhileNobodyVotes) {
  VoteNotices notices;
  for (std::uint32_t voters = 0; voters < 5; ++voters) EXPECT_EQ(notices.take({1, 0, voters}, voters), std::nullopt);
  EXPECT_EQ(notices.told(), std::nullopt);
}

TEST(VoteNotices, EveryChangeIsToldButAtMostFourASecond) {
  VoteNotices notices;
  EXPECT_EQ(notices.take({1, 1, 3}, 10), (VoteCount{1, 1, 3}));
  EXPECT_EQ(notices.told(), (VoteCount{1, 1, 3}));
  EXPECT_EQ(notices.take({1, 1, 3}, 500), std::nullopt) << "no change";
  EXPECT_EQ(notices.take({1, 1, 4}, 500), (VoteCount{1, 1, 4}));
  EXPECT_EQ(notices.take({1, 2, 4}, 500 + VoteNotices::kMinTicks - 1), std::nullopt) << "too soon";
  EXPECT_EQ(notices.take({1, 2, 5}, 500 + VoteNotices::kMinTicks), (VoteCount{1, 2, 5})) << "the newest";
}

TEST(VoteNotices, TheEndOfTheLastVoteIsTold) {
  VoteNotices notices;
  notices.take({1, 1, 3}, 10);
  EXPECT_EQ(notices.take({1, 0, 3}, 100), (VoteCount{1, 0, 0}));
  EXPECT_EQ(notices.told(), std::nullopt);
}

TEST(VoteNotices, ARoundBeginsWithoutVotes) {
  VoteNotices notices;
  notices.take({1, 1, 3}, 10);
  notices.startRound();
  EXPECT_EQ(notices.told(), std::nullopt);
  EXPECT_EQ(notices.take({2, 0, 3}, 100), std::nullopt);
}

using Kind = MatchEvent::Kind;

LevelPointer titled(const std::string& title, const std::string& text) {
  return levelOf("# title: " + title + "\n" + text);
}

Hello helloOf(ClientId client) {
  Hello hello;
  hello.name = "P" + std::to_string(client);
  hello.token = SessionToken{static_cast<std::uint8_t>(client)};
  return hello;
}

/// A match without a network: messages of clients take effect at once.
class MatchRoundsTest : public testing::Test {
 protected:
  void join(ClientId client) { match_.receive(client, helloOf(client)); }
  void join(ClientId first, ClientId last) {
    for (ClientId client = first; client <= last; ++client) join(client);
  }
  void vote(ClientId client, bool next = true) { match_.receive(client, Vote{match_.round(), next}); }
  void run(std::uint64_t ticks = 1) {
    for (; ticks > 0; --ticks) match_.tick();
  }

  // The cause of the end of the round, of which the events since the last call tell; empty: it goes on.
  std::string cause() {
    for (const MatchEvent& event : match_.takeEvents()) {
      if (event.kind == Kind::kRoundEnd) return event.text;
    }
    return "";
  }

  // The messages of this type that a client has been sent since the last call.
  template <class Message>
  std::vector<Message> sentTo(ClientId client) {
    std::vector<Message> found;
    for (const Outgoing& sent : match_.takeOutgoing()) {
      const auto message = decodeToClient(sent.bytes);
      const auto* wanted = message ? std::get_if<Message>(&*message) : nullptr;
      if (wanted && sent.client == client) found.push_back(*wanted);
    }
    return found;
  }

  LevelPointer far_ = titled("Far away", farGoalText());
  LevelPointer near_ = titled("Near by", nearGoalText());
  Match match_{LevelRotation({far_, near_}), {16, "Test"}};
};

TEST_F(MatchRoundsTest, AVotePassesExactlyWithMoreThanHalfOfThePlayers) {
  for (ClientId players = 1; players <= 9; ++players) {
    match_ = Match(LevelRotation({far_, near_}), {16, "Test"});
    join(1, players);
    for (ClientId client = 1; client <= players; ++client) {
      run();
      EXPECT_EQ(cause(), "") << client - 1 << " of " << players;
      vote(client);
      run();
      if (2 * client <= players) continue;
      EXPECT_EQ(cause(), "vote") << client << " of " << players;
      break;
    }
    run(MatchRounds::kPauseTicks - 1);
    EXPECT_EQ(match_.round(), 1u);
    run();
    EXPECT_EQ(match_.round(), 2u);
    EXPECT_EQ(match_.game().level().hash, near_->hash);
  }
}

TEST_F(MatchRoundsTest, APlayerWhoLeavesLowersTheBar) {
  join(1, 4);
  vote(1);
  vote(2);
  run(50);
  EXPECT_EQ(cause(), "");
  match_.remove(4);
  run();
  EXPECT_EQ(cause(), "vote");
}

TEST_F(MatchRoundsTest, ADisconnectedPlayerHasNoVoteAndIsNoVoter) {
  join(1, 5);
  for (const ClientId client : {1u, 2u}) vote(client);
  run(10);
  match_.disconnect(2);
  run(10);
  EXPECT_EQ(cause(), "") << "1 of 4";
  match_.disconnect(3);
  match_.disconnect(4);
  run();
  EXPECT_EQ(cause(), "") << "1 of 2";
  match_.disconnect(5);
  run();
  EXPECT_EQ(cause(), "vote") << "1 of 1";
}

TEST_F(MatchRoundsTest, AResumedPlayerHasNotVoted) {
  join(1, 3);
  vote(1);
  run(10);
  match_.disconnect(1);
  run(10);
  match_.receive(11, helloOf(1));
  vote(2);
  run(100);
  EXPECT_EQ(cause(), "") << "1 of 3";
  vote(11);
  run();
  EXPECT_EQ(cause(), "vote");
}

// A vote counts as activity, as a button does.
TEST_F(MatchRoundsTest, APlayerThatHasBeenInactiveForAMinuteIsNoVoter) {
  join(1, 4);
  run(30);
  vote(1);
  run(MatchPlayer::kActiveTicks - 31);
  EXPECT_EQ(cause(), "") << "1 of 4";
  run();
  EXPECT_EQ(cause(), "vote") << "1 of 1";
}

TEST_F(MatchRoundsTest, AVoteCanBeTakenBack) {
  join(1, 3);
  vote(1);
  run();
  vote(1, false);
  run(VoteWish::kMinTicks);
  vote(2);
  run(200);
  EXPECT_EQ(cause(), "") << "1 of 3";
}

TEST_F(MatchRoundsTest, AVoteForAnotherRoundHasNoEffect) {
  join(1);
  for (const std::uint32_t round : {0u, 2u, UINT32_MAX}) match_.receive(1, Vote{round, true});
  run(100);
  EXPECT_EQ(cause(), "");
}

TEST_F(MatchRoundsTest, AVoteDuringThePauseHasNoEffectNowOrLater) {
  join(1);
  run();
  match_.endRoundNow();
  EXPECT_EQ(cause(), "operator");
  vote(1);
  run(MatchRounds::kPauseTicks + 100);
  EXPECT_EQ(cause(), "");
  EXPECT_EQ(match_.round(), 2u);
}

TEST_F(MatchRoundsTest, VotesEndWithTheirRound) {
  join(1, 3);
  vote(1);
  run();
  match_.endRoundNow();
  run(MatchRounds::kPauseTicks);
  cause();
  vote(2);
  run(100);
  EXPECT_EQ(cause(), "") << "1 of 3";
}

TEST_F(MatchRoundsTest, AClientThatHasNotJoinedHasNoVote) {
  join(1, 2);
  vote(1);
  vote(9);
  run(100);
  EXPECT_EQ(cause(), "");
}

TEST_F(MatchRoundsTest, PlayersAreToldTheCountWhenItChanges) {
  join(1, 5);
  run(50);
  EXPECT_TRUE(sentTo<VoteCount>(3).empty()) << "nobody has voted";
  vote(1);
  run();
  EXPECT_EQ(sentTo<VoteCount>(3), (std::vector<VoteCount>{{1, 1, 5}}));
  vote(2);
  run(100);
  EXPECT_EQ(sentTo<VoteCount>(3), (std::vector<VoteCount>{{1, 2, 5}}));
  match_.remove(5);
  run();
  EXPECT_EQ(sentTo<VoteCount>(3), (std::vector<VoteCount>{{1, 2, 4}}));
  join(6);
  run();
  EXPECT_EQ(sentTo<VoteCount>(6), (std::vector<VoteCount>{{1, 2, 4}})) << "at first what the others know";
  run(VoteNotices::kMinTicks);
  EXPECT_EQ(sentTo<VoteCount>(6), (std::vector<VoteCount>{{1, 2, 5}}));
}

// A flood of votes costs the others at most this.
TEST_F(MatchRoundsTest, AFloodOfVotesSendsAtMostOneMessageASecond) {
  join(1, 5);
  run(100);
  sentTo<VoteCount>(3);
  std::size_t sent = 0;
  constexpr int kSeconds = 10;
  for (int tick = 0; tick < kSeconds * kTicksPerSecond; ++tick) {
    for (int i = 0; i < 101; ++i) vote(1, (tick + i) % 2 == 0);
    run();
    sent += sentTo<VoteCount>(3).size();
  }
  EXPECT_LE(sent, std::size_t{kSeconds});
  EXPECT_EQ(cause(), "");
}

TEST_F(MatchRoundsTest, AFinishInTheTickOfAVoteEndsTheRoundOnce) {
  KeptTimes times;
  match_ = Match(LevelRotation({near_, far_}), {4, "Test"}, {.bestTimes = &times});
  join(1);
  PlayerInputs inputs;
  inputs.round = 1;
  inputs.inputs.assign(10, Input{Input::kPresent});
  match_.receive(1, inputs);
  vote(1);
  match_.takeOutgoing();
  run();
  const std::vector<RoundEnd> ends = sentTo<RoundEnd>(1);
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0].best, (LevelBest{1, "P1", true}));
  EXPECT_EQ(cause(), "finished");
  run(MatchRounds::kPauseTicks - 1);
  EXPECT_TRUE(sentTo<RoundEnd>(1).empty());
}

TEST_F(MatchRoundsTest, TheEndNamesTheNextLevelAndThePause) {
  join(1);
  run(20);
  match_.takeOutgoing();
  match_.endRoundNow();
  const RoundEnd expected{1, 20, near_->hash, "Near by", MatchRounds::kPauseTicks, std::nullopt};
  EXPECT_EQ(sentTo<RoundEnd>(1), std::vector{expected});
  run(10);
  join(2);
  EXPECT_EQ(sentTo<RoundEnd>(2), std::vector{expected}) << "a newcomer sees the countdown too";
}

TEST_F(MatchRoundsTest, NewLevelsDuringThePauseAreNamedAgain) {
  join(1);
  run();
  match_.setLevels({near_});
  EXPECT_TRUE(sentTo<RoundEnd>(1).empty()) << "the round goes on";
  match_.endRoundNow();
  match_.takeOutgoing();
  match_.setLevels({levelOf(farGoalText())});
  const std::vector<RoundEnd> ends = sentTo<RoundEnd>(1);
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0].nextTitle, "HEXAHEDRON") << "a level without a title";
  run(MatchRounds::kPauseTicks);
  EXPECT_EQ(match_.game().level().hash, ends[0].nextLevelHash);
}

TEST_F(MatchRoundsTest, ALevelForTwoIsNextOnlyWhileTwoPlayersAreThere) {
  const LevelPointer pair = titled("For two", "# players: 2\n" + nearGoalText());
  match_ = Match(LevelRotation({far_, pair, near_}), {16, "Test"});
  const auto nextTitles = [this] {
    std::vector<std::string> titles;
    for (const RoundEnd& end : sentTo<RoundEnd>(1)) titles.push_back(end.nextTitle);
    return titles;
  };
  join(1, 2);
  run();
  match_.endRoundNow();
  EXPECT_EQ(nextTitles(), std::vector<std::string>{"For two"});
  match_.remove(2);
  run(2);
  EXPECT_EQ(nextTitles(), std::vector<std::string>{"Near by"});
  join(2);
  run(2);
  EXPECT_EQ(nextTitles(), std::vector<std::string>{"For two"});
  run(MatchRounds::kPauseTicks - 6);
  EXPECT_EQ(match_.round(), 1u) << "the next tick would start the next round";
  match_.remove(2);
  run();
  EXPECT_EQ(match_.round(), 1u);
  EXPECT_EQ(nextTitles(), std::vector<std::string>{"Near by"});
  run();
  EXPECT_EQ(match_.round(), 2u);
  EXPECT_EQ(match_.game().level().hash, near_->hash);
}

TEST_F(MatchRoundsTest, WhoComesAfterAllHaveLeftGetsALevelForOne) {
  const LevelPointer pair = titled("For two", "# players: 2\n" + nearGoalText());
  match_ = Match(LevelRotation({far_, pair, near_}), {16, "Test"});
  join(1, 2);
  run();
  match_.startNextRound();
  EXPECT_EQ(match_.game().level().hash, pair->hash);
  run(5);
  match_.remove(1);
  match_.remove(2);
  join(3);
  EXPECT_EQ(match_.game().level().hash, near_->hash);
}

}  // namespace
}  // namespace platon::rounds_test
