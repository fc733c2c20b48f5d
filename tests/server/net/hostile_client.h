#pragma once

#include <enet/enet.h>

#include <cstdint>
#include <optional>

#include "protocol/transport/client_gate.h"
#include "server/net/host.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/raw_content.h"

namespace platon {

/// Somebody who has a session but sends into it what he likes.
class HostileClient {
 public:
  HostileClient(DatagramNetwork& network, const SocketAddress& own, const SocketAddress& server)
      : gate_(network.socket(own), {server}, {}, KeyPair::random()) {}

  /// One exchange with the host. Notes which peer of the host the session became.
  void step(Host& host, Time now) {
    gate_.update(now);
    host.service(now);
    while (const std::optional<Bytes> content = gate_.receive(now)) note(*content);
  }

  void join(Host& host, Time now) {
    for (int i = 0; i < 3; ++i) step(host, now);
  }

  /// Also completes ENet's handshake.
  void connect(Host& host, Time now) {
    join(host, now);
    send(connectContent(77), now);
    step(host, now);
    const auto time = static_cast<std::uint16_t>(now / std::chrono::milliseconds(1));
    send(acknowledgeContent(peer_, 1, 0xff, time), now);
    step(host, now);
  }

  void send(ByteSpan content, Time now) { gate_.send(content, now); }
  std::uint16_t peer() const { return peer_; }

 private:
  // The host's own number follows the command header of VERIFY_CONNECT; its session follows in the head of our
  // datagrams.
  void note(const Bytes& content) {
    const std::size_t at = kCommandAt;
    if (content.size() < at + 8 || (content[at] & ENET_PROTOCOL_COMMAND_MASK) != ENET_PROTOCOL_COMMAND_VERIFY_CONNECT)
      return;
    const int number = content[at + 4] << 8 | content[at + 5];
    const int session = content[at + 7];
    peer_ = static_cast<std::uint16_t>(number | session << ENET_PROTOCOL_HEADER_SESSION_SHIFT);
  }

  ClientGate gate_;
  std::uint16_t peer_ = 0;
};

}  // namespace platon
