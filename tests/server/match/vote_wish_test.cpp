#include "server/match/vote_wish.h"

#include <gtest/gtest.h>

namespace platon::vote_wish_test {
namespace {

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

}  // namespace
}  // namespace platon::vote_wish_test
