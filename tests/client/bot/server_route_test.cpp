#include "client/bot/server_route.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace platon::server_route_test {
namespace {

TEST(ServerRoute, IsDirectUnderPerfectConditions) {
  const ServerRoute route({"example.invalid", 7801}, LinkQuality(), 1);
  EXPECT_EQ(route.address().text(), "example.invalid:7801");
}

TEST(ServerRoute, UsesALocalRelayUnderSimulatedConditions) {
  LinkQuality quality;
  quality.delayMs = 1;
  const ServerRoute route({"127.0.0.1", 7801}, quality, 1);
  EXPECT_EQ(route.address().host, "127.0.0.1");
  EXPECT_NE(route.address().port, 7801);
}

TEST(ServerRoute, ThrowsForAnUnknownHostBehindARelay) {
  LinkQuality quality;
  quality.delayMs = 1;
  EXPECT_THROW(ServerRoute({"no such host", 1}, quality, 1), std::runtime_error);
}

}  // namespace
}  // namespace platon::server_route_test
