#include "protocol/transport/recent_keys.h"

#include <gtest/gtest.h>

namespace platon::recent_keys_test {
namespace {

using std::chrono::seconds;

TEST(RecentKeys, RemembersAKeyInItsEpochAndTheNextOne) {
  RecentKeys keys(seconds(10));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(25)));
  keys.add(CryptoKey{1}, seconds(25));
  EXPECT_TRUE(keys.contains(CryptoKey{1}, seconds(25)));
  EXPECT_FALSE(keys.contains(CryptoKey{2}, seconds(25)));
  EXPECT_TRUE(keys.contains(CryptoKey{1}, seconds(39)));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(40)));
}

TEST(RecentKeys, ForgetsAllWhenNothingWasAskedForAWholeEpoch) {
  RecentKeys keys(seconds(10));
  keys.add(CryptoKey{1}, seconds(25));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(45)));
}

// A list of 4 096 keys forgot the oldest while their cookies were still valid.
TEST(RecentKeys, ForgetsNoneHoweverManyThereAre) {
  RecentKeys keys(seconds(60));
  const auto keyOf = [](std::uint32_t number) {
    CryptoKey key{};
    for (std::size_t i = 0; i < 4; ++i) key[i] = static_cast<std::uint8_t>(number >> (8 * i));
    return key;
  };
  for (std::uint32_t number = 0; number < 60'000; ++number) keys.add(keyOf(number), seconds(60 + number / 500));
  for (std::uint32_t number = 30'000; number < 60'000; ++number)
    ASSERT_TRUE(keys.contains(keyOf(number), seconds(179)));
  EXPECT_TRUE(keys.contains(keyOf(0), seconds(179)));
}

}  // namespace
}  // namespace platon::recent_keys_test
