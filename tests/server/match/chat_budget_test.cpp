#include "server/match/chat_budget.h"

#include <gtest/gtest.h>

namespace platon::chat_budget_test {
namespace {

TEST(ChatBudget, ABurstIsSaidAtOnceAndThenOneTextInTwoSeconds) {
  ChatBudget budget = ChatBudget::ofPlayers(1);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(budget.take(0));
  EXPECT_FALSE(budget.take(0));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond - 1));
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, WhatIsDroppedDoesNotCount) {
  ChatBudget budget = ChatBudget::ofPlayers(1);
  for (int i = 0; i < 100; ++i) budget.take(0);
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, TheTimeDoesNotWrapWithinACentury) {
  ChatBudget budget = ChatBudget::ofPlayers(4);
  const std::uint64_t year = std::uint64_t{365} * 24 * 3600 * kTicksPerSecond;
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(budget.take(100 * year));
  EXPECT_FALSE(budget.take(100 * year));
}

// Where a budget counts as full, it is forgotten.
TEST(ChatBudget, IsFullAfterEightSeconds) {
  for (const std::uint32_t players : {1u, 4u, 16u}) {
    ChatBudget budget = ChatBudget::ofPlayers(players);
    for (std::uint32_t i = 0; i < 4 * players; ++i) EXPECT_TRUE(budget.take(0));
    EXPECT_FALSE(budget.take(0));
    for (std::uint32_t i = 0; i < 4 * players; ++i) EXPECT_TRUE(budget.take(ChatBudget::kRefillTicks));
  }
  EXPECT_EQ(ChatBudget::kRefillTicks, 8 * kTicksPerSecond);
}

TEST(NetworkChat, ANetworkSaysAsMuchAsItsPlayers) {
  NetworkChat chat(4);
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, kTicksPerSecond / 2 - 1));
  EXPECT_TRUE(chat.take(7, kTicksPerSecond / 2));
  EXPECT_TRUE(chat.take(8, 0)) << "another one";
}

TEST(NetworkChat, NoNetworkSaysMoreThanSixteenPlayers) {
  NetworkChat chat(kMaxPlayers);
  for (int i = 0; i < 64; ++i) EXPECT_TRUE(chat.take(7, 0));
  EXPECT_FALSE(chat.take(7, 0));
}

TEST(NetworkChat, KeepsOnlyThoseWhoHaveTalkedLately) {
  NetworkChat chat(4);
  for (std::uint64_t network = 1; network <= 1000; ++network) chat.take(network, network);
  EXPECT_EQ(chat.size(), ChatBudget::kRefillTicks);
  for (int i = 0; i < 15; ++i) EXPECT_TRUE(chat.take(1000, 1000));
  EXPECT_FALSE(chat.take(1000, 1000)) << "it has said one already";
}

}  // namespace
}  // namespace platon::chat_budget_test
