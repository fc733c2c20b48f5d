#pragma once

#include <enet/enet.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/net/connection.h"
#include "protocol/time.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/enet_layer.h"

namespace platon {

/// A sealed connection to a server over ENet. The only class of the client that calls ENet.
class Connection : private EnetPort {
 public:
  /// Longest pause between two connection requests of ENet.
  static constexpr Time kRequestInterval = std::chrono::milliseconds(500);
  /// Messages that one `service` delivers at most; further ones wait for the next call.
  static constexpr std::uint32_t kMaxMessagesPerService = 512;

  enum class State { kConnecting, kConnected, kClosed };
  using Receiver = std::function<void(std::span<const std::uint8_t>)>;

  /// Why the server does not take the client: a sentence for the player.
  struct Refused {
    std::string reason;
    bool permanent = true;      ///< false: a later attempt may succeed
    bool asksPassword = false;  ///< the server asks for a password, or for another one
  };

  /// Starts to connect to a server at one of these addresses, over UDP. Throws SocketError if no socket is available.
  Connection(const std::vector<SocketAddress>& addresses, const ServerKnowledge& knowledge);
  /// The same over another socket.
  Connection(std::unique_ptr<DatagramSocket> socket, const std::vector<SocketAddress>& addresses,
             const ServerKnowledge& knowledge);
  ~Connection() override;

  /// Passes received messages to `receiver` and sends queued datagrams. Does not block, except for the tenth of a
  /// second in which a password becomes a key, once for all connections with copies of the same password.
  void service(Time now, const Receiver& receiver);
  /// Sends the queued messages.
  void flush(Time now);
  /// Queues a message for the next `flush` or `service`. No effect unless connected.
  void send(std::span<const std::uint8_t> message, bool reliable);
  /// Closes the connection once all queued messages have been acknowledged.
  void close();

  State state() const { return state_; }
  /// Set when the server or the gate has refused the client; the state is then kClosed.
  const std::optional<Refused>& refused() const { return refused_; }
  /// The server's identity, once the connection is sealed.
  std::optional<CryptoKey> identity() const;
  const Traffic& traffic() const { return gate_.traffic(); }

 private:
  struct DestroyHost {
    void operator()(ENetHost* host) const { enet_host_destroy(host); }
  };

  void sendFromEnet(const ENetAddress& session, ByteSpan bytes) override;
  std::optional<Received> receiveForEnet() override;
  bool accepts(ByteSpan content) const;
  void shakeHands();
  void connect();
  void handle(const ENetEvent& event, const Receiver& receiver);

  ClientGate gate_;
  std::unique_ptr<ENetHost, DestroyHost> host_;
  ENetPeer* peer_ = nullptr;  // once the gate is open
  State state_ = State::kConnecting;
  std::optional<Refused> refused_;
  Time now_{};     // of the present call
  Bytes content_;  // the last one handed to ENet
};

/// Why a gate that has ended the handshake did so, as a sentence for the player.
Connection::Refused refusalOf(const ClientGate& gate);

}  // namespace platon
