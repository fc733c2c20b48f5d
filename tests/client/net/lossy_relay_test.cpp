#include "client/net/lossy_relay.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

#include "client/net/connection.h"
#include "protocol/transport/udp_socket.h"
#include "tests/support/wait_until.h"

namespace platon::lossy_relay_test {
namespace {

using std::chrono::milliseconds;

// A UDP socket on a free loopback port.
class Socket {
 public:
  Socket() : handle_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_in own = loopback(0);
    socklen_t size = sizeof own;
    if (bind(handle_, reinterpret_cast<sockaddr*>(&own), size) != 0 ||
        getsockname(handle_, reinterpret_cast<sockaddr*>(&own), &size) != 0) {
      throw std::runtime_error("no socket");
    }
    port_ = ntohs(own.sin_port);
  }
  ~Socket() { close(handle_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  std::uint16_t port() const { return port_; }
  void send(const std::string& text, std::uint16_t port) {
    const sockaddr_in to = loopback(port);
    ASSERT_EQ(sendto(handle_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to),
              static_cast<ssize_t>(text.size()));
  }
  // The next datagram, if one has arrived. Sets `senderPort()`.
  std::optional<std::string> receive() {
    char buffer[256];
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t count = recvfrom(handle_, buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return std::nullopt;
    senderPort_ = ntohs(from.sin_port);
    return std::string(buffer, static_cast<std::size_t>(count));
  }
  // The port that the last datagram came from.
  std::uint16_t senderPort() const { return senderPort_; }

 private:
  static sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
  }

  int handle_;
  std::uint16_t port_ = 0;
  std::uint16_t senderPort_ = 0;
};

class LossyRelayTest : public testing::Test {
 protected:
  void start(const LinkQuality& quality) { relay_.emplace(ServerAddress{"127.0.0.1", server_.port()}, quality, 1); }
  void sendToRelay(Socket& from, const std::string& text) { from.send(text, relay_->address().port); }
  void pump() { relay_->pump(now_ += milliseconds(1)); }

  // Pumps the relay until the socket receives a datagram.
  std::optional<std::string> receive(Socket& socket) {
    std::optional<std::string> datagram;
    const auto step = [&] {
      pump();
      datagram = socket.receive();
    };
    stepUntil(step, [&] { return datagram.has_value(); });
    return datagram;
  }

  // Expects that the relay has sent nothing more: a datagram sent to the socket directly is the next one.
  void expectNothingMore(Socket& socket) {
    Socket direct;
    for (int ms = 0; ms < 100; ++ms) pump();
    direct.send("direct", socket.port());
    EXPECT_EQ(receive(socket), "direct");
  }

  Socket server_;
  std::optional<LossyRelay> relay_;
  Moment now_{};
};

TEST_F(LossyRelayTest, ForwardsDatagramsBothWaysWithDelay) {
  Socket client;
  LinkQuality slow;
  slow.delayMs = 30;
  start(slow);
  sendToRelay(client, "question");
  ASSERT_EQ(receive(server_), "question");
  EXPECT_GE(now_, milliseconds(30));
  const Moment answered = now_;
  server_.send("answer", server_.senderPort());
  EXPECT_EQ(receive(client), "answer");
  EXPECT_GE(now_ - answered, milliseconds(30));
}

TEST_F(LossyRelayTest, DropsEverythingAtFullLoss) {
  Socket client;
  LinkQuality lossy;
  lossy.lossPercent = 100;
  start(lossy);
  sendToRelay(client, "question");
  expectNothingMore(server_);
}

template <class Call>
std::string fault(Call call) {
  try {
    call();
    return "none";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(LossyRelay, ReportsAnUnknownHostLikeAConnection) {
  const ServerAddress nowhere{"no such host", 1};
  EXPECT_EQ(fault([&] { LossyRelay(nowhere, LinkQuality(), 1); }), "cannot resolve host no such host");
  EXPECT_EQ(fault([&] { resolve(nowhere.host, nowhere.port); }), "cannot resolve host no such host");
}

// Behaves like a NAT router: the server sees a new address, and datagrams to the old one are lost.
TEST_F(LossyRelayTest, AClientOnANewPortGetsANewPortTowardsTheServer) {
  Socket before, after;
  LinkQuality quality;
  quality.delayMs = 50;
  start(quality);
  sendToRelay(before, "one");
  ASSERT_EQ(receive(server_), "one");
  const std::uint16_t first = server_.senderPort();
  server_.send("to the first", first);
  sendToRelay(before, "too late");
  pump();
  sendToRelay(after, "two");
  ASSERT_EQ(receive(server_), "two");
  const std::uint16_t second = server_.senderPort();
  EXPECT_NE(first, second);
  server_.send("to the first again", first);
  server_.send("to the second", second);
  EXPECT_EQ(receive(after), "to the second");
  expectNothingMore(after);
  expectNothingMore(before);
}

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
}  // namespace platon::lossy_relay_test
