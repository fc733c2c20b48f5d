#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "client/lobby/near_servers.h"
#include "client/time/steady_now.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/dedicated_server.h"
#include "tests/net/support/datagram_network.h"
#include "tests/support/test_levels.h"

namespace platon::near_servers_network_test {
namespace {

constexpr Time kEnd = std::chrono::seconds(60);

// 127.255.255.255 reaches all sockets of this machine that listen on all of its addresses, as the broadcast address of
// a network does.
TEST(NearServersNetwork, AServerAnswersASearchOfItsWholeNetworkOnce) {
  ServerSettings settings;
  settings.match.serverName = "Den of Plato";
  DedicatedServer server(settings, {endlessLevel()}, Log(LogFormat::kText, [](std::string_view) {}));
  auto socket = std::make_unique<UdpSocket>();
  socket->allowBroadcast();
  const std::uint16_t port = server.port();
  NearServers servers(std::move(socket), {addressAt("127.255.255.255", port), addressAt("127.0.0.1", port)}, 42);
  const Clock clock = steadyClock();
  const Time begin = clock.now();
  for (Time now = begin; now < begin + kEnd && servers.list().empty(); now = clock.now()) {
    servers.update(now);
    server.step(TimePoint(now));
    servers.socket().wait(std::chrono::milliseconds(2));
  }
  ASSERT_EQ(servers.list().size(), 1U);
  EXPECT_EQ(servers.list()[0].info.name, "Den of Plato");
  EXPECT_EQ(servers.list()[0].address, addressAt("127.0.0.1", port));
  EXPECT_FALSE(servers.list()[0].info.needsPassword);
}

}  // namespace
}  // namespace platon::near_servers_network_test
