#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "client/net/enet_link.h"
#include "client/session/network_client.h"
#include "protocol/limits.h"
#include "protocol/to_client.h"
#include "protocol/transport/udp_socket.h"
#include "tests/net/support/loopback_server.h"

namespace platon::other_release_test {
namespace {

using std::chrono::seconds;

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kVersionByte = 5;  // of a datagram of the handshake: after its kind and "PLTN"

SocketAddress serverAt(const ServerAddress& address) { return resolve(address.host, address.port).front(); }

/// Forwards the datagrams of one client, and makes its program look newer to the server by some versions of the
/// protocol, and the server older to it.
class VersionRelay {
 public:
  VersionRelay(const ServerAddress& server, int newer) : server_(serverAt(server)), newer_(newer) {}

  ServerAddress address() const { return {kLoopback, clientSide_.address().port}; }

  void pump(Time now) {
    while (const std::optional<Datagram> sent = clientSide_.receive(now)) {
      client_ = sent->peer;
      serverSide_.send(server_, shifted(sent->bytes, newer_), now);
    }
    while (const std::optional<Datagram> sent = serverSide_.receive(now)) {
      clientSide_.send(client_, shifted(sent->bytes, -newer_), now);
    }
    serverSide_.flush(now);
    clientSide_.flush(now);
  }

 private:
  static Bytes shifted(ByteSpan datagram, int versions) {
    Bytes bytes(datagram.begin(), datagram.end());
    if (readHead(bytes)) bytes[kVersionByte] = static_cast<std::uint8_t>(bytes[kVersionByte] + versions);
    return bytes;
  }

  SocketAddress server_;
  SocketAddress client_{};
  int newer_;
  UdpSocket clientSide_{kLoopback, 0}, serverSide_{kLoopback, 0};
};

// How a client ends that is newer than the server by so many versions of the protocol: what stands after the address.
std::optional<std::string> endingOf(int newer) {
  LoopbackServer server;
  VersionRelay relay(server.address(), newer);
  NetworkClient client(enetLinks(server.address(), relay.address()), NetworkClient::Profile{"Ann"},
                       server.clock().now());
  const auto update = [&](Time now) {
    relay.pump(now);
    client.update(now, [](const Game&, std::uint32_t) { return Input{}; });
    relay.pump(now);
  };
  server.runUntil(seconds(5), update, [&] { return client.ending() || client.welcomed(); });
  EXPECT_EQ(client.welcomed(), newer == 0);
  const std::string address = server.address().text() + ": ";
  if (!client.ending() || !client.ending()->starts_with(address)) return client.ending();
  return client.ending()->substr(address.size());
}

TEST(OtherRelease, OfTheProtocolTheClientSaysWhichProgramToUpdate) {
  const std::string own = std::to_string(kProtocolVersion);
  EXPECT_EQ(endingOf(0), std::nullopt);
  EXPECT_EQ(endingOf(-1), "the server is newer (protocol version " + std::to_string(kProtocolVersion + 1) +
                              ", your client " + own + "): update your client");
  EXPECT_EQ(endingOf(1), "the server is older (protocol version " + std::to_string(kProtocolVersion - 1) +
                             ", your client " + own + "): its owner must update it");
}

// What the server answers to a client that has these rules and shakes hands as every client does.
std::optional<Refused> answerTo(std::uint32_t rules) {
  LoopbackServer server;
  EnetLink connection({serverAt(server.address())}, {});
  std::optional<Refused> refused;
  bool greeted = false;
  const auto update = [&](Time now) {
    connection.service(now, [&refused](std::span<const std::uint8_t> bytes) {
      const auto message = decodeToClient(bytes);
      if (message && std::holds_alternative<Refused>(*message)) refused = std::get<Refused>(*message);
    });
    if (!greeted && connection.state() == EnetLink::State::kConnected) {
      connection.send(encode(Hello{rules, "Ann"}), true);
      greeted = true;
    }
    connection.flush(now);
  };
  server.runUntil(seconds(1), update, [&] { return refused.has_value(); });
  EXPECT_EQ(server.server().match().players(), refused ? 0u : 1u);
  return refused;
}

TEST(OtherRelease, OfTheRulesTheServerSaysWhichProgramToUpdate) {
  const std::string own = std::to_string(kRulesVersion);
  EXPECT_EQ(answerTo(kRulesVersion), std::nullopt);
  const std::optional<Refused> older = answerTo(kRulesVersion - 1);
  ASSERT_TRUE(older);
  EXPECT_EQ(older->code, RefusalCode::kWrongRules);
  EXPECT_EQ(older->reason, "the server is newer (rules version " + own + ", your client " +
                               std::to_string(kRulesVersion - 1) + "): update your client");
  const std::optional<Refused> newer = answerTo(kRulesVersion + 1);
  ASSERT_TRUE(newer);
  EXPECT_EQ(newer->reason, "the server is older (rules version " + own + ", your client " +
                               std::to_string(kRulesVersion + 1) + "): its owner must update it");
}

}  // namespace
}  // namespace platon::other_release_test
