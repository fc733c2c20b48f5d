#include "server/match/chat_budget.h"

#include <gtest/gtest.h>

namespace platon::chat_budget_test {
namespace {

TEST(ChatBudget, ABurstIsSaidAtOnceAndThenOneTextInTwoSeconds) {
  ChatBudget budget = ChatBudget::ofPlayer();
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(budget.take(0));
  EXPECT_FALSE(budget.take(0));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond - 1));
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
  EXPECT_FALSE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, WhatIsDroppedDoesNotCount) {
  ChatBudget budget = ChatBudget::ofPlayer();
  for (int i = 0; i < 100; ++i) budget.take(0);
  EXPECT_TRUE(budget.take(2 * kTicksPerSecond));
}

TEST(ChatBudget, TheTimeDoesNotWrapWithinACentury) {
  ChatBudget budget = ChatBudget::ofAll();
  const std::uint64_t year = std::uint64_t{365} * 24 * 3600 * kTicksPerSecond;
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(budget.take(100 * year));
  EXPECT_FALSE(budget.take(100 * year));
}

}  // namespace
}  // namespace platon::chat_budget_test
