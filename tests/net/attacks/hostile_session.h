#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "protocol/transport/client_gate.h"
#include "tests/net/attacks/attack_network.h"

namespace platon {

/// A session of somebody who sends into it what he likes.
class HostileSession {
 public:
  using Receiver = std::function<void(const Bytes& content)>;

  /// `receiver`, if there is one, gets each content that arrives.
  HostileSession(AttackNetwork& network, const IpAddress& own, Receiver receiver = {});
  ~HostileSession();

  /// Goes on with the handshake, then with that of ENet.
  void step(Time now);
  bool isSealed() const { return gate_.state() == ClientGate::State::kOpen; }
  /// The server's number of the connection; nothing before ENet's handshake.
  std::optional<std::uint16_t> peer() const { return peer_; }
  void send(ByteSpan content, Time now) { gate_.send(content, now); }
  /// The same in the name of another address.
  void sendFrom(const SocketAddress& name, ByteSpan content, Time now);
  /// From now on it sends nothing but in other names, and answers no challenge.
  void leaveAddress();
  /// Goes on from another address of the attacker's own, and answers challenges there.
  void move(const IpAddress& own);

 private:
  class MaskedSocket;

  HostileSession(AttackNetwork& network, std::unique_ptr<MaskedSocket> socket, Receiver receiver);
  void note(const Bytes& content, Time now);

  MaskedSocket* socket_;
  ClientGate gate_;
  Receiver receiver_;
  std::optional<std::uint16_t> peer_;
  bool requested_ = false;
};

}  // namespace platon
