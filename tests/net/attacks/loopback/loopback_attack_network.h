#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "tests/net/attacks/attack_network.h"
#include "tests/net/attacks/loopback/loopback_socket.h"

namespace platon {

/// The loopback interface before a real server. Honest players join through a relay, so that each has an address of its
/// own, and that the attacker can read and forge what they send.
class LoopbackAttackNetwork : public AttackNetwork {
 public:
  explicit LoopbackAttackNetwork(const SocketAddress& server);

  void send(const SocketAddress& from, ByteSpan datagram) override;
  std::unique_ptr<DatagramSocket> socket(const IpAddress& own) override;
  SocketAddress server() const override { return server_; }

  /// Where honest players join.
  SocketAddress relay() const { return relay_.address(); }
  /// Relays what has arrived, and reads the answers to the attacker's datagrams.
  void pump();

  /// Datagrams that the attacker has sent, and bytes that came for addresses that answer nothing.
  std::uint64_t sent() const { return sent_; }
  std::uint64_t answeredBytes() const { return answeredBytes_; }

 private:
  class CountingSocket;
  struct Player {
    SocketAddress own;  // at the relay's side of the player
    std::unique_ptr<LoopbackSocket> socket;
  };

  Player& playerAt(const SocketAddress& own);
  void count(ByteSpan datagram);

  SocketAddress server_;
  LoopbackSocket relay_;
  LoopbackSocket strangers_;
  std::map<SocketAddress, std::unique_ptr<Player>> players_;  // by own address
  std::map<SocketAddress, Player*> victims_;                  // by the address that the server knows
  std::uint64_t sent_ = 0;
  std::uint64_t answeredBytes_ = 0;
};

}  // namespace platon
