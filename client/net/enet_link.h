#pragma once

#include <enet/enet.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/net/message_link.h"
#include "protocol/time.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/enet_layer.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// A sealed link to a server over ENet. The only class of the client that calls ENet.
class EnetLink final : public MessageLink, private EnetPort {
 public:
  /// Longest pause between two connection requests of ENet.
  static constexpr Time kRequestInterval = std::chrono::milliseconds(500);
  /// Messages that one `service` delivers at most; further ones wait for the next call.
  static constexpr std::uint32_t kMaxMessagesPerService = 512;

  /// Starts to connect to a server at one of these addresses, over UDP. Throws SocketError if no socket is available.
  EnetLink(const std::vector<SocketAddress>& addresses, const ServerKnowledge& knowledge);
  /// The same over another socket.
  EnetLink(std::unique_ptr<DatagramSocket> socket, const std::vector<SocketAddress>& addresses,
           const ServerKnowledge& knowledge);
  ~EnetLink() override;

  /// Does not block, except for the tenth of a second in which a password becomes a key, once for all links with copies
  /// of the same password.
  void service(Time now, const Receiver& receiver) override;
  void flush(Time now) override;
  void send(std::span<const std::uint8_t> message, bool reliable) override;
  void close() override;

  State state() const override { return state_; }
  const std::optional<Refused>& refused() const override { return refused_; }
  std::optional<CryptoKey> identity() const override;
  Traffic traffic() const override { return gate_.traffic(); }

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
MessageLink::Refused refusalOf(const ClientGate& gate);

/// The links to a server, or through a relay to it. Looks up the host name, once. Throws SocketError if it cannot be
/// resolved.
ServerLinks enetLinks(const ServerAddress& server, const std::optional<ServerAddress>& relay = {});

}  // namespace platon
