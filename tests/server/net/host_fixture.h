#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "client/net/enet_link.h"
#include "server/net/host.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/raw_content.h"
#include "tests/server/net/hostile_client.h"

namespace platon {

/// A host and a client in memory and in virtual time.
class HostTest : public testing::Test {
 protected:
  static inline const SocketAddress kServer = addressAt("198.51.100.1", 7777);
  static inline const SocketAddress kClient = addressAt("192.0.2.1", 4000);
  static inline const SocketAddress kEve = addressAt("192.0.2.66", 4000);

  void step() {
    now_ += std::chrono::milliseconds(1);
    for (const HostEvent& event : host_.service(now_)) {
      events_.push_back({event.client, event.disconnected, {}});
      messages_.emplace_back(event.bytes.begin(), event.bytes.end());
    }
    host_.flush(now_);
    client_.service(now_, [this](std::span<const std::uint8_t> message) {
      received_.emplace_back(message.begin(), message.end());
    });
    client_.flush(now_);
  }

  template <class Done>
  bool run(Done done) {
    for (int ms = 0; ms < 20000 && !done(); ++ms) step();
    return done();
  }

  // Connects the client and sends a message, so that its number becomes known.
  ClientId connect() {
    EXPECT_TRUE(run([this] { return client_.state() == EnetLink::State::kConnected; }));
    client_.send(Bytes{1, 2, 3}, true);
    EXPECT_TRUE(run([this] { return !events_.empty(); }));
    return events_.at(0).client;
  }

  static HostSettings settings() {
    HostSettings settings;
    settings.connections = 4;
    return settings;
  }

  DatagramNetwork network_;
  Time now_ = std::chrono::seconds(1000);
  ServerIdentity identity_ = ServerIdentity::random();
  Host host_{network_.socket(kServer), identity_, settings(), now_};
  EnetLink client_{network_.socket(kClient), {kServer}, {}};
  HostileClient eve_{network_, kEve, kServer};
  std::vector<HostEvent> events_;  // without their bytes
  std::vector<Bytes> messages_;    // of these
  std::vector<Bytes> received_;
};

}  // namespace platon
