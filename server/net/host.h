#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/match/client_id.h"
#include "server/net/time_point.h"
#include "server/net/token_bucket.h"

struct _ENetHost;
struct _ENetPeer;
struct _ENetEvent;

namespace platon {

/// The socket cannot be opened; `what()` is one sentence that states the cause and how to correct it.
class HostError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct HostSettings {
  std::string bind = "0.0.0.0";    ///< IPv4 address of this machine
  std::uint16_t port = 0;          ///< 0: any that is free
  std::uint32_t connections = 24;  ///< most connections, 1 … 4000; more than players, so that a client can be refused
  std::uint32_t connectionsPerAddress = 4;  ///< most connections of one address; loopback has no limit
};

/// Traffic that `Host` has rejected so far.
struct HostCounters {
  std::uint64_t invalidDatagrams = 0;  ///< datagrams that no client sends
  std::uint64_t excessDatagrams = 0;   ///< datagrams beyond the budget of their connection
  std::uint64_t excessConnects = 0;    ///< requests to connect beyond the budget of their address
  std::uint64_t expired = 0;           ///< connections that were not admitted in time

  friend bool operator==(const HostCounters&, const HostCounters&) = default;
};

/// A message from a client, or the end of its connection.
struct HostEvent {
  ClientId client = 0;
  bool disconnected = false;  ///< the connection has ended; otherwise `bytes` is a message
  std::vector<std::uint8_t> bytes;
  std::uint32_t origin = 0;  ///< of a message: number of its IPv4 address; 0 for loopback
};

/// The server's end of all connections. Only this class and datagram_check use ENet on the server. ENet trusts its
/// peers; docs/protocol.md lists how the server protects itself. All times are monotonic and never decrease.
class Host {
 public:
  /// Time after its first datagram in which a client must complete ENet's handshake, which proves its address.
  static constexpr std::chrono::seconds kAnswerTime{3};
  /// Time after the handshake in which a client must be admitted. It is long because its Hello may have to be sent
  /// repeatedly under loss.
  static constexpr std::chrono::seconds kAdmissionTime{10};

  /// Opens the socket. Throws HostError.
  Host(const HostSettings& settings, TimePoint now);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Receives what has arrived, closes connections that have timed out, and returns the events.
  std::vector<HostEvent> service(TimePoint now);
  /// Call when the client plays: from then on its connection ends only when it is closed or silent.
  void admit(ClientId client);
  /// Queues a message. No effect if the client is disconnected.
  void send(ClientId client, bool reliable, std::span<const std::uint8_t> message);
  /// Closes the connection once everything queued has arrived, or after kAnswerTime. Until then messages may still
  /// arrive; `isOpen` is false for them.
  void close(ClientId client, TimePoint now);
  /// Sends the queued messages.
  void flush(TimePoint now);

  /// Sleeps until a datagram arrives, a signal is caught or `timeout` has passed.
  void wait(std::chrono::milliseconds timeout) const;

  std::uint16_t port() const;
  /// False if the client is disconnected or its connection is closing.
  bool isOpen(ClientId client) const;
  /// Whether no client is connected or connecting.
  bool empty() const;
  const HostCounters& counters() const { return counters_; }

 private:
  struct Connection;  // state of one ENet peer
  struct Service;

  static int intercept(_ENetHost* host, _ENetEvent* event);
  bool acceptsDatagram(TimePoint now);
  bool acceptsConnect(TimePoint now);
  bool isRetransmittedConnect() const;
  std::size_t silentConnectionsOfSender(TimePoint now) const;
  void handle(const _ENetEvent& event, TimePoint now, std::vector<HostEvent>& events);
  void maintain(std::size_t index, TimePoint now, std::vector<HostEvent>& events);
  _ENetPeer* peerOf(ClientId client) const;

  std::unique_ptr<_ENetHost, void (*)(_ENetHost*)> host_;
  std::uint32_t connectionsPerAddress_;
  std::vector<Connection> connections_;  // by index of the ENet peer
  std::vector<TokenBucket> connects_;    // by a keyed hash of the address
  std::uint32_t connectKey_;
  ClientId nextClient_ = 1;
  HostCounters counters_;
};

}  // namespace platon
