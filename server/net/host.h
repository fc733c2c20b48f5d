#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
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

/// The socket cannot be opened; `what()` is one sentence that says why and how to mend it.
class HostError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct HostSettings {
  std::string bind = "0.0.0.0";             ///< IPv4 address of this machine
  std::uint16_t port = 0;                   ///< 0: any that is free
  std::uint32_t connections = 24;           ///< at most, 1 … 4000; a few more than players, to be able to refuse
  std::uint32_t connectionsPerAddress = 4;  ///< loopback counts without limit
};

/// What `Host` has kept from the game so far.
struct HostCounters {
  std::uint64_t brokenDatagrams = 0;  ///< that no client of ours sends
  std::uint64_t excessDatagrams = 0;  ///< over a connection's budget
  std::uint64_t excessConnects = 0;   ///< over an address's budget
  std::uint64_t expired = 0;          ///< connections that did not get to play in time

  friend bool operator==(const HostCounters&, const HostCounters&) = default;
};

/// Something that came from a client.
struct HostEvent {
  ClientId client = 0;
  bool gone = false;  ///< the connection has ended; else `bytes` is a message
  std::vector<std::uint8_t> bytes;
  std::uint32_t origin = 0;  ///< of a message: a number for its address, as `Match` wants it; 0 for loopback
};

/// The server's end of all connections, and the only place on this side that knows ENet. ENet by itself is not fit for
/// the internet; what is done about it is in docs/protocol.md. All times are monotonic and never decrease.
class Host {
 public:
  /// Time from the first datagram until the other side must have proven its address by an answer.
  static constexpr std::chrono::seconds kAnswerTime{3};
  /// Time from then until it must be admitted: on a line that loses much, a greeting takes some repetitions.
  static constexpr std::chrono::seconds kAdmissionTime{10};

  /// Opens the socket. Throws HostError.
  Host(const HostSettings& settings, TimePoint now);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Takes in what has arrived, drops connections that have timed out, and returns what happened.
  std::vector<HostEvent> service(TimePoint now);
  /// The client plays: from now on it stays until it leaves or is silent.
  void admit(ClientId client);
  /// Queues a message. Without effect when the client is gone.
  void send(ClientId client, bool reliable, std::span<const std::uint8_t> message);
  /// Ends the connection once everything queued has arrived, or after kAnswerTime. Until then messages may still
  /// come, to which `listensTo` says no.
  void close(ClientId client, TimePoint now);
  /// Sends what is queued.
  void flush(TimePoint now);

  /// Sleeps until a datagram arrives, a signal is caught or the time has passed.
  void wait(std::chrono::milliseconds atMost) const;

  std::uint16_t port() const;
  /// False when the client is gone or its connection is ending.
  bool listensTo(ClientId client) const;
  /// Whether anybody is connected or connecting.
  bool empty() const;
  const HostCounters& counters() const { return counters_; }

 private:
  struct Link;  // what is known of one ENet peer
  struct Service;

  static int intercept(_ENetHost* host, _ENetEvent* event);
  bool lets(TimePoint now);
  bool letsConnect(TimePoint now);
  bool isRepeated() const;
  std::size_t silentOfSender(TimePoint now) const;
  void take(const _ENetEvent& event, TimePoint now, std::vector<HostEvent>& events);
  void tend(std::size_t index, TimePoint now, std::vector<HostEvent>& events);
  _ENetPeer* peerOf(ClientId client) const;

  std::unique_ptr<_ENetHost, void (*)(_ENetHost*)> host_;
  std::uint32_t connectionsPerAddress_;
  std::vector<Link> links_;            // by ENet's number of the peer
  std::vector<TokenBucket> connects_;  // by a keyed hash of the address
  std::uint32_t connectKey_;
  ClientId nextClient_ = 1;
  HostCounters counters_;
};

}  // namespace platon
