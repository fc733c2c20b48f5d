#include "client/network_conditions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace platon {
namespace {

using std::chrono::milliseconds;

constexpr int kDatagrams = 20000;

struct Arrival {
  int number;
  Moment sent;
  Moment received;
};

std::vector<std::uint8_t> numbered(int number) {
  return {static_cast<std::uint8_t>(number & 0xff), static_cast<std::uint8_t>(number >> 8 & 0xff)};
}

// Sends one datagram every 10 ms and looks every millisecond.
std::vector<Arrival> carry(const LinkQuality& quality, std::uint64_t seed) {
  NetworkConditions line(quality, seed);
  std::vector<Arrival> arrivals;
  for (int ms = 0; ms < kDatagrams * 10 + 5000; ++ms) {
    if (ms % 10 == 0 && ms / 10 < kDatagrams) line.send(numbered(ms / 10), milliseconds(ms));
    while (const auto datagram = line.receive(milliseconds(ms))) {
      const int number = (*datagram)[0] | (*datagram)[1] << 8;
      arrivals.push_back({number, milliseconds(number * 10), milliseconds(ms)});
    }
  }
  EXPECT_EQ(line.pending(), 0u);
  return arrivals;
}

bool inOrder(const std::vector<Arrival>& arrivals) {
  return std::is_sorted(arrivals.begin(), arrivals.end(),
                        [](const Arrival& a, const Arrival& b) { return a.number < b.number; });
}

TEST(NetworkConditions, PerfectLineDeliversAtOnce) {
  const LinkQuality perfect;
  EXPECT_TRUE(perfect.perfect());
  const auto arrivals = carry(perfect, 1);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  EXPECT_TRUE(inOrder(arrivals));
  for (const Arrival& arrival : arrivals) ASSERT_EQ(arrival.received, arrival.sent);
}

TEST(NetworkConditions, LosesItsShare) {
  LinkQuality quality;
  quality.lossPercent = 20;
  EXPECT_FALSE(quality.perfect());
  EXPECT_NEAR(static_cast<double>(carry(quality, 2).size()), kDatagrams * 0.8, kDatagrams * 0.01);
}

TEST(NetworkConditions, DelaysWithinBoundsAndInOrder) {
  LinkQuality quality;
  quality.delayMs = 50;
  quality.jitterMs = 30;
  const auto arrivals = carry(quality, 3);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  EXPECT_TRUE(inOrder(arrivals));
  Moment longest{};
  for (const Arrival& arrival : arrivals) {
    ASSERT_GE(arrival.received - arrival.sent, milliseconds(50));
    ASSERT_LE(arrival.received - arrival.sent, milliseconds(81));
    longest = std::max(longest, arrival.received - arrival.sent);
  }
  EXPECT_GT(longest, milliseconds(75));
}

TEST(NetworkConditions, DuplicatesItsShare) {
  LinkQuality quality;
  quality.duplicatePercent = 10;
  std::map<int, int> copies;
  for (const Arrival& arrival : carry(quality, 4)) ++copies[arrival.number];
  EXPECT_EQ(copies.size(), std::size_t{kDatagrams});
  const auto twice = std::count_if(copies.begin(), copies.end(), [](const auto& entry) { return entry.second == 2; });
  EXPECT_NEAR(static_cast<double>(twice), kDatagrams * 0.1, kDatagrams * 0.01);
}

TEST(NetworkConditions, ReordersItsShare) {
  LinkQuality quality;
  quality.reorderPercent = 10;
  const auto arrivals = carry(quality, 5);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  int overtaken = 0;
  int newest = -1;
  for (const Arrival& arrival : arrivals) {
    overtaken += arrival.number < newest ? 1 : 0;
    newest = std::max(newest, arrival.number);
  }
  EXPECT_NEAR(overtaken, kDatagrams * 0.1, kDatagrams * 0.01);
}

TEST(NetworkConditions, SameSeedSameDeliveries) {
  LinkQuality quality;
  quality.lossPercent = 10;
  quality.jitterMs = 20;
  quality.reorderPercent = 5;
  const auto key = [](const std::vector<Arrival>& arrivals) {
    std::vector<std::pair<int, Moment>> keys;
    for (const Arrival& arrival : arrivals) keys.emplace_back(arrival.number, arrival.received);
    return keys;
  };
  EXPECT_EQ(key(carry(quality, 6)), key(carry(quality, 6)));
  EXPECT_NE(key(carry(quality, 6)), key(carry(quality, 7)));
}

}  // namespace
}  // namespace platon
