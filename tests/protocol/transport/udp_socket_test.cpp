#include "protocol/transport/udp_socket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/net/support/datagram_network.h"
#include "tests/net/support/raw_socket.h"

namespace platon::udp_socket_test {
namespace {

constexpr Time kNow{};

std::string errorOf(const std::string& bind, std::uint16_t port, int exitCode = ProgramError::kUsage) {
  try {
    const UdpSocket socket(bind, port);
    return "none";
  } catch (const SocketError& error) {
    EXPECT_EQ(error.exitCode(), exitCode);
    return error.what();
  }
}

// The next datagram, waiting for it at most a minute.
std::optional<Datagram> next(UdpSocket& socket) {
  for (int i = 0; i < 600; ++i) {
    if (const auto datagram = socket.receive(kNow)) return datagram;
    socket.wait(std::chrono::milliseconds(100));
  }
  return std::nullopt;
}

TEST(UdpSocket, SaysWhyItCannotListen) {
  const UdpSocket socket("127.0.0.1", 0);
  const std::uint16_t port = socket.address().port;
  EXPECT_EQ(errorOf("127.0.0.1", port, ProgramError::kFailed),
            "cannot listen on 127.0.0.1:" + std::to_string(port) +
                ": Address already in use; stop the program that uses it or choose another port after --port");
  EXPECT_TRUE(errorOf("2001:db8::1", 7777).starts_with("cannot listen on [2001:db8::1]:7777: "));
  EXPECT_EQ(errorOf("here", 0), "cannot listen on 'here': it is not an IP address; name one such as 127.0.0.1 or ::");
  EXPECT_NE(errorOf("192.0.2.1", 0).find("choose an address of this machine after --bind, or :: for all"),
            std::string::npos);
}

TEST(UdpSocket, DatagramsArriveWithTheirSender) {
  UdpSocket server("127.0.0.1", 0);
  UdpSocket client;
  client.send(server.address(), Bytes{1, 2, 3}, kNow);
  client.flush(kNow);
  const auto request = next(server);
  ASSERT_TRUE(request);
  EXPECT_EQ(Bytes(request->bytes.begin(), request->bytes.end()), (Bytes{1, 2, 3}));
  EXPECT_EQ(request->peer, addressAt("127.0.0.1", client.address().port));
  server.send(request->peer, Bytes{4}, kNow);
  server.flush(kNow);
  const auto answer = next(client);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->peer, server.address());
}

// ENet took an empty datagram for "nothing waits": 150 of them a second stopped a server.
TEST(UdpSocket, EmptyAndOversizedDatagramsAreSeen) {
  UdpSocket server("127.0.0.1", 0);
  const RawSocket attacker(server.address());
  for (const std::size_t size : {std::size_t{0}, kMaxDatagramBytes, kMaxDatagramBytes + 1, kMaxDatagramBytes + 200}) {
    attacker.send(Bytes(size));
    const auto datagram = next(server);
    ASSERT_TRUE(datagram);
    EXPECT_EQ(datagram->bytes.size(), std::min(size, kMaxDatagramBytes + 1));
  }
}

TEST(UdpSocket, ABatchThatTheSystemRefusesDoesNotStopTheOthers) {
  UdpSocket server("127.0.0.1", 0);
  UdpSocket client("127.0.0.1", 0);
  const SocketAddress nowhere = addressAt("192.0.2.1", 0);
  for (std::uint8_t i = 0; i < 100; ++i) {
    client.send(i % 3 == 0 ? nowhere : server.address(), Bytes{i}, kNow);
  }
  client.flush(kNow);
  std::set<int> arrived;
  for (int i = 0; i < 66; ++i) {
    const auto datagram = next(server);
    ASSERT_TRUE(datagram);
    arrived.insert(datagram->bytes[0]);
  }
  EXPECT_EQ(arrived.size(), 66u);
}

TEST(UdpSocket, SendsToAWholeNetworkOnlyIfAllowed) {
  UdpSocket server("0.0.0.0", 0);
  const SocketAddress all = addressAt("127.255.255.255", server.address().port);
  UdpSocket client;
  client.send(all, Bytes{1}, kNow);
  client.flush(kNow);
  client.allowBroadcast();
  client.send(all, Bytes{2}, kNow);
  client.flush(kNow);
  const auto datagram = next(server);
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->bytes[0], 2);
}

TEST(UdpSocket, AllAddressesMeansBothKinds) {
  UdpSocket server("::", 0);
  const std::uint16_t port = server.address().port;
  UdpSocket client;
  std::vector<SocketAddress> servers{addressAt("127.0.0.1", port)};
  const bool hasIpv6 = errorOf("::1", 0) == "none";
  if (hasIpv6) servers.push_back(addressAt("::1", port));
  for (const SocketAddress& address : servers) {
    client.send(address, Bytes{1}, kNow);
    client.flush(kNow);
    const auto datagram = next(server);
    ASSERT_TRUE(datagram) << address.text();
    EXPECT_EQ(datagram->peer.ip, address.ip);
  }
}

TEST(Resolve, AnAddressIsItself) {
  EXPECT_EQ(resolve("127.0.0.1", 5), (std::vector{addressAt("127.0.0.1", 5)}));
  EXPECT_EQ(resolve("::1", 5), (std::vector{addressAt("::1", 5)}));
  const std::vector<SocketAddress> local = resolve("localhost", 5);
  EXPECT_NE(std::find(local.begin(), local.end(), addressAt("127.0.0.1", 5)), local.end());
  EXPECT_THROW(resolve("no such host", 5), SocketError);
}

}  // namespace
}  // namespace platon::udp_socket_test
