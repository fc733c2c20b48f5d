#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "protocol/token_bucket.h"
#include "protocol/transport/enet_layer.h"
#include "protocol/transport/server_gate.h"
#include "protocol/transport/server_sessions.h"
#include "server/base/client_id.h"

namespace platon {

struct HostSettings {
  std::uint32_t connections = 80;  ///< most connections, 1 … 4000; more than players, so that newcomers find one free
  std::uint32_t connectionsPerAddress = 8;  ///< most connections of one address; loopback has no limit
  CryptoKey presharedKey{};                 ///< of the password
  bool needsPassword = false;
};

/// What the program around a host decides about addresses. A function that is empty refuses nobody.
struct HostRules {
  std::function<std::optional<std::string>(const IpAddress&)> ban{};  ///< as in GateRules
  std::function<void(const IpAddress&)> banned{};                     ///< as in GateRules
  /// Decides whether a client may move to another address.
  std::function<bool(ClientId, const IpAddress&)> mayMove{};
};

/// A message from a client, or the end of its connection.
struct HostEvent {
  ClientId client = 0;
  bool disconnected = false;  ///< the connection has ended; otherwise `bytes` is a message
  ByteSpan bytes;             ///< valid until the next call of `Host::service`
};

/// The server's end of all connections: ENet behind a gate. ENet trusts its peers, so every content is checked before
/// ENet sees it; docs/security.md lists what a client can try. All times are monotonic and never decrease.
class Host : private EnetPort {
 public:
  /// Time after the first sealed datagram in which a client must complete ENet's handshake.
  static constexpr std::chrono::seconds kAnswerTime{3};
  /// Time after the handshake in which a client must be admitted. It is long because its Hello may have to be sent
  /// repeatedly under loss.
  static constexpr std::chrono::seconds kAdmissionTime{10};
  /// Largest number of reliable messages that wait for a client's acknowledgement. A connection that would exceed it
  /// ends.
  static constexpr std::size_t kMaxQueuedMessages = 128;
  /// A connection ends when a client has not acknowledged a reliable message or ping for so long since it was first
  /// sent.
  static constexpr std::chrono::seconds kMaxUnacknowledged{10};

  /// Throws SocketError if ENet cannot be used.
  Host(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity, const HostSettings& settings, Time now,
       HostRules rules = {});
  ~Host() override;

  /// Receives what has arrived, ends connections that have timed out, and returns the events. They are valid until the
  /// next call.
  std::span<const HostEvent> service(Time now);
  /// Call when the client plays: from then on its connection ends only when it is closed or silent.
  void admit(ClientId client);
  /// Queues a message. No effect if the client is disconnected.
  void send(ClientId client, bool reliable, std::span<const std::uint8_t> message);
  /// Number of reliable messages that can be sent to the client now, so that it can keep up; 0 if it is disconnected.
  std::size_t room(ClientId client) const;
  /// Average round trip to the client, milliseconds, as ENet measures it by what the client acknowledges; 0 if it is
  /// disconnected.
  std::uint32_t roundTripMs(ClientId client) const;
  /// Closes the connection once everything queued has arrived, or after kAnswerTime. Until then messages may still
  /// arrive; `isOpen` is false for them.
  void close(ClientId client, Time now);
  /// Sends the queued messages.
  void flush(Time now);

  /// Sleeps until a datagram arrives, a signal is caught or `timeout` has passed.
  void wait(std::chrono::milliseconds timeout) { gate_.socket().wait(timeout); }

  SocketAddress address() const { return gate_.socket().address(); }
  ServerGate& gate() { return gate_; }
  const ServerGate& gate() const { return gate_; }
  /// Where the client is now; `IpAddress{}` if it is disconnected.
  IpAddress addressOf(ClientId client) const;
  /// False if the client is disconnected or its connection is closing.
  bool isOpen(ClientId client) const;
  /// Whether no client is connected or connecting.
  bool empty() const;
  /// All that the gate and the host have rejected so far, and what those behind them add.
  Rejections& rejections() { return gate_.rejections(); }
  const Rejections& rejections() const { return gate_.rejections(); }

 private:
  // A command that waits for its acknowledgement.
  struct Outstanding {
    std::uint8_t channel = 0;
    std::uint16_t sequence = 0;
    std::size_t bytes = 0;
    Time since;  // when it was first sent
  };

  // What the host knows of one ENet peer, and what the peer may do.
  struct Connection {
    explicit Connection(Time now, SessionId own = {});

    // False, which is counted, if the connection has sent more than it may.
    bool charge(std::size_t size, Rejections& rejections, Time now);
    void limitResends(ENetPeer& peer, Time now);
    void noteOutstanding(const ENetPeer& peer, Time now);
    // If so, why is counted.
    bool hasTimedOut(Rejections& rejections, Time now) const;

    std::optional<ClientId> client;  // once connected
    SessionId session;               // number 0: the peer is free
    bool admitted = false;
    bool closing = false;
    Time since;       // when it became open, connected or closing, whichever came last
    Time receivedAt;  // when the last datagram arrived
    TokenBucket datagrams;
    TokenBucket bytes;
    TokenBucket resends;                   // bytes that may be sent again
    std::size_t window;                    // most bytes of messages that may be outstanding
    std::vector<Outstanding> outstanding;  // when it was noted last
  };

  using Packet = std::unique_ptr<ENetPacket, void (*)(ENetPacket*)>;

  GateRules gateRules(HostRules rules);
  void sendFromEnet(const ENetAddress& session, ByteSpan bytes) override;
  std::optional<Received> receiveForEnet() override;
  bool accepts(SessionId session, Bytes& content);
  void endSlow();
  bool acceptsConnect(SessionId session, std::uint32_t connectId, std::size_t bytes);
  bool begin(SessionId session, std::size_t bytes);
  void handle(const ENetEvent& event);
  void connect(Connection& connection, ENetPeer& peer);
  void maintain(std::size_t index);
  void end(std::size_t index);
  std::optional<std::size_t> indexOf(ClientId client) const;

  ServerGate gate_;
  std::unique_ptr<ENetHost, void (*)(ENetHost*)> host_;
  std::vector<Connection> connections_;                // by index of the ENet peer
  std::unordered_map<ClientId, std::size_t> indexes_;  // in connections_, of the connected ones
  std::vector<ClientId> slow_;                         // that the next call of `service` ends
  std::vector<HostEvent> events_;                      // of the last call of `service`
  std::vector<Packet> packets_;                        // with the messages of these
  ClientId nextClient_ = 1;
  Time now_;       // of the present call
  Bytes content_;  // the last one handed to ENet
};

}  // namespace platon
