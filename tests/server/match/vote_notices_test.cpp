#include "server/match/vote_notices.h"

#include <gtest/gtest.h>

namespace platon::vote_notices_test {
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

}  // namespace
}  // namespace platon::vote_notices_test
