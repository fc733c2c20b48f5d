#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_gate.h"
#include "tests/net/support/datagram_network.h"

namespace platon {

/// A gate and clients in memory and in virtual time.
class ServerGateTest : public testing::Test {
 protected:
  static inline const SocketAddress kServer = addressAt("198.51.100.1", 7777);
  static inline const Bytes kContent{1, 2, 3, 4, 5, 6, 7, 8, 9};

  static SocketAddress clientAt(int number) { return addressAt("192.0.2." + std::to_string(number), 4000); }

  void start(GateSettings settings = {4, 2, {}, false}) {
    gate_.emplace(network_.socket(kServer), identity_, settings, now_, rules());
  }

  // A client that has finished its handshake, or has been refused.
  ClientGate join(const SocketAddress& own, const std::string& password = "") {
    ClientGate client(network_.socket(own), {kServer}, {std::nullopt, password}, KeyPair::random());
    client.update(now_);
    for (int roundTrip = 0; roundTrip < 2; ++roundTrip) {
      receive();
      client.receive(now_);
    }
    now_ += std::chrono::milliseconds(600);
    return client;
  }

  // What comes from sessions.
  std::vector<ServerGate::Received> receive() {
    std::vector<ServerGate::Received> all;
    while (auto received = gate_->receive(now_)) all.push_back(std::move(*received));
    return all;
  }

  // The session of a client, found by a first content.
  SessionId sessionOf(ClientGate& client) {
    client.send(kContent, now_);
    const auto received = receive();
    EXPECT_EQ(received.size(), 1u);
    EXPECT_EQ(received.at(0).bytes, kContent);
    gate_->confirm(received.at(0).session);
    return received.at(0).session;
  }

  // The datagrams from one address to another.
  std::vector<Bytes> sent(const SocketAddress& from, const SocketAddress& to) const {
    std::vector<Bytes> datagrams;
    for (const auto& each : network_.sent()) {
      if (each.from == from && each.to == to) datagrams.push_back(each.bytes);
    }
    return datagrams;
  }

  // What `rules_` says at the time.
  GateRules rules() {
    return {[this](const IpAddress& ip) { return rules_.ban ? rules_.ban(ip) : std::nullopt; },
            [this](const IpAddress& ip) {
              if (rules_.banned) rules_.banned(ip);
            },
            [this](SessionId session, const IpAddress& ip) { return !rules_.mayMove || rules_.mayMove(session, ip); }};
  }

  DatagramNetwork network_;
  ServerIdentity identity_ = ServerIdentity::random();
  Time now_ = std::chrono::seconds(1000);
  GateRules rules_;  // a test may change it at any time
  std::optional<ServerGate> gate_;
};

}  // namespace platon
