#include "protocol/transport/recent_keys.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

using std::chrono::seconds;

TEST(RecentKeys, RemembersAKeyForItsLifetime) {
  RecentKeys keys(4, seconds(10));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(0)));
  keys.add(CryptoKey{1}, seconds(0));
  EXPECT_TRUE(keys.contains(CryptoKey{1}, seconds(9)));
  EXPECT_FALSE(keys.contains(CryptoKey{2}, seconds(9)));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(10)));
}

TEST(RecentKeys, ForgetsTheOldestWhenFull) {
  RecentKeys keys(3, seconds(10));
  for (std::uint8_t i = 1; i <= 5; ++i) keys.add(CryptoKey{i}, seconds(0));
  for (std::uint8_t i = 1; i <= 5; ++i) EXPECT_EQ(keys.contains(CryptoKey{i}, seconds(1)), i > 2) << int{i};
}

}  // namespace
}  // namespace platon
