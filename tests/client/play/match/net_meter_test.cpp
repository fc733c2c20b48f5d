#include "client/play/match/session_feeds.h"

#include <chrono>

#include <gtest/gtest.h>

#include "client/net/enet_link.h"
#include "tests/net/support/loopback_server.h"

namespace platon::net_meter_test {
namespace {

using std::chrono::seconds;

TEST(NetMeter, SamplesARunningClient) {
  LoopbackServer server;
  NetworkClient client(enetLinks(server.address()), {""}, server.clock().now());
  NetMeter meter;
  NetSample sample;
  Time last{};
  const auto update = [&](Time now) {
    last = now;
    client.update(now, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
    if (client.session() != nullptr) sample = meter.sample(client, now);
  };
  ASSERT_TRUE(server.runUntil(seconds(10), update, [&] {
    return client.session() != nullptr && client.session()->predictionStatistics().confirmedTicks > 120;
  }));
  EXPECT_GT(sample.aheadTicks, 0);
  EXPECT_GT(sample.downBytesPerSecond, 100);
  EXPECT_GT(sample.upBytesPerSecond, 100);
  const Traffic total = client.traffic();
  EXPECT_LT(sample.downBytesPerSecond, static_cast<double>(total.receivedBytes));  // only of the last second
  EXPECT_EQ(sample.corrections, client.session()->predictionStatistics().corrections);
  for (int i = 0; i < 60; ++i) sample = meter.sample(client, last += std::chrono::milliseconds(20));
  EXPECT_DOUBLE_EQ(sample.framesPerSecond, 50);
}

}  // namespace
}  // namespace platon::net_meter_test
