#include "protocol/transport/network_budgets.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::network_budgets_test {
namespace {

using std::chrono::milliseconds;

constexpr Moment kStart = std::chrono::seconds(1000);
constexpr CryptoKey kKey{1, 2, 3};
constexpr double kPerSecond = 2;
constexpr int kLimit = 8;
constexpr std::uint64_t kAttacker = 77;

NetworkBudgets budgets(const CryptoKey& key = kKey) { return {kPerSecond, kLimit, key, kStart}; }

TEST(NetworkBudgetsTest, ANetworkHasItsLimitAtOnceAndThenItsRate) {
  NetworkBudgets some = budgets();
  for (int i = 0; i < kLimit; ++i) EXPECT_TRUE(some.take(5, kStart)) << i;
  EXPECT_FALSE(some.take(5, kStart));
  EXPECT_FALSE(some.take(5, kStart + milliseconds(499)));
  EXPECT_TRUE(some.take(5, kStart + milliseconds(500)));
  EXPECT_FALSE(some.take(5, kStart + milliseconds(500)));
}

TEST(NetworkBudgetsTest, HoldsWhatCanBeTaken) {
  NetworkBudgets some = budgets();
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(some.holds(5, kStart)) << "it takes nothing";
  while (some.take(5, kStart)) {
  }
  EXPECT_FALSE(some.holds(5, kStart));
  EXPECT_FALSE(some.holds(5, kStart + milliseconds(499)));
  EXPECT_TRUE(some.holds(5, kStart + milliseconds(500)));
}

// With one bucket each, several of these newcomers would share that of the attacker.
TEST(NetworkBudgetsTest, AnAttackerKeepsNoNewcomerOut) {
  NetworkBudgets attacked = budgets();
  for (int i = 0; i < 1000; ++i) attacked.take(kAttacker, kStart);
  for (std::uint64_t newcomer = 1000; newcomer < 11000; ++newcomer) {
    NetworkBudgets left = attacked;
    ASSERT_TRUE(left.take(newcomer, kStart)) << newcomer;
  }
}

TEST(NetworkBudgetsTest, TheKeyDecidesWhoShares) {
  // They use up an eighth of the buckets, so that one newcomer in 64 finds both of its own empty.
  constexpr int kAttackers = 64;
  const auto keptOut = [](const CryptoKey& key) {
    NetworkBudgets attacked = budgets(key);
    for (std::uint64_t attacker = 0; attacker < kAttackers; ++attacker) {
      for (int i = 0; i < kLimit; ++i) attacked.take(attacker, kStart);
    }
    std::vector<std::uint64_t> refused;
    for (std::uint64_t newcomer = 1000; newcomer < 2000; ++newcomer) {
      NetworkBudgets left = attacked;
      if (!left.take(newcomer, kStart)) refused.push_back(newcomer);
    }
    return refused;
  };
  const std::vector<std::uint64_t> some = keptOut(kKey);
  EXPECT_GT(some.size(), 5U);
  EXPECT_LT(some.size(), 40U);
  EXPECT_EQ(keptOut(kKey), some);
  EXPECT_NE(keptOut({3, 2, 1}), some);
}

}  // namespace
}  // namespace platon::network_budgets_test
