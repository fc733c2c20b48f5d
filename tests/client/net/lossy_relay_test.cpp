#include "client/net/lossy_relay.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "client/net/connection.h"

namespace platon {
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
  // Waits up to 50 ms for a datagram.
  std::optional<std::string> receive(std::uint16_t* sender = nullptr) {
    char buffer[256];
    sockaddr_in from{};
    socklen_t size = sizeof from;
    for (int look = 0; look < 50; ++look) {
      const ssize_t count = recvfrom(handle_, buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&from), &size);
      if (count >= 0) {
        if (sender != nullptr) *sender = ntohs(from.sin_port);
        return std::string(buffer, static_cast<std::size_t>(count));
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
    return std::nullopt;
  }

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
};

void pumpFor(LossyRelay& relay, Moment from, Moment until) {
  for (Moment now = from; now <= until; now += milliseconds(1)) {
    relay.pump(now);
    std::this_thread::sleep_for(milliseconds(1));
  }
}

TEST(LossyRelay, ForwardsDatagramsBothWaysWithDelay) {
  Socket client, server;
  LinkQuality slow;
  slow.delayMs = 30;
  LossyRelay relay({"127.0.0.1", server.port()}, slow, 1);
  client.send("question", relay.address().port);
  pumpFor(relay, milliseconds(0), milliseconds(10));
  pumpFor(relay, milliseconds(11), milliseconds(45));
  std::uint16_t relaysPort = 0;
  ASSERT_EQ(server.receive(&relaysPort), "question");
  server.send("answer", relaysPort);
  pumpFor(relay, milliseconds(50), milliseconds(60));
  EXPECT_EQ(client.receive(), std::nullopt);
  pumpFor(relay, milliseconds(61), milliseconds(100));
  EXPECT_EQ(client.receive(), "answer");
}

TEST(LossyRelay, DropsEverythingAtFullLoss) {
  Socket client, server;
  LinkQuality lossy;
  lossy.lossPercent = 100;
  LossyRelay relay({"localhost", server.port()}, lossy, 1);
  client.send("question", relay.address().port);
  pumpFor(relay, milliseconds(0), milliseconds(20));
  EXPECT_EQ(server.receive(), std::nullopt);
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
  EXPECT_EQ(fault([&] { Connection(nowhere, Moment(1)); }), "cannot resolve host no such host");
}

// Behaves like a NAT router: the server sees a new address, and datagrams to the old one are lost.
TEST(LossyRelay, AClientOnANewPortGetsANewPortTowardsTheServer) {
  Socket server, before, after;
  LinkQuality quality;
  quality.delayMs = 50;
  LossyRelay relay({"127.0.0.1", server.port()}, quality, 1);
  const auto pass = [&relay](int fromMs) {
    for (int ms = fromMs; ms < fromMs + 60; ++ms) relay.pump(milliseconds(ms));
  };
  std::uint16_t first = 0, second = 0;
  before.send("one", relay.address().port);
  pass(0);
  ASSERT_EQ(server.receive(&first), "one");
  server.send("to the first", first);
  before.send("too late", relay.address().port);
  relay.pump(milliseconds(100));
  after.send("two", relay.address().port);
  pass(100);
  ASSERT_EQ(server.receive(&second), "two");
  EXPECT_NE(first, second);
  server.send("to the first again", first);
  server.send("to the second", second);
  pass(200);
  EXPECT_EQ(after.receive(), "to the second");
  EXPECT_FALSE(after.receive().has_value());
  EXPECT_FALSE(before.receive().has_value());
}

}  // namespace
}  // namespace platon
