#pragma once

#include <enet/enet.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "client/net/server_address.h"
#include "client/time/moment.h"

namespace platon {

/// What went over the wire: UDP payload, acknowledgements and resent packets included.
struct Traffic {
  std::uint64_t sentBytes = 0;
  std::uint64_t sentPackets = 0;
  std::uint64_t receivedBytes = 0;
  std::uint64_t receivedPackets = 0;
  std::uint64_t longestDatagram = 0;  ///< either way, bytes; of a difference: ever

  friend Traffic operator+(const Traffic& a, const Traffic& b) {
    return {a.sentBytes + b.sentBytes, a.sentPackets + b.sentPackets, a.receivedBytes + b.receivedBytes,
            a.receivedPackets + b.receivedPackets, std::max(a.longestDatagram, b.longestDatagram)};
  }
  friend Traffic operator-(const Traffic& a, const Traffic& b) {
    return {a.sentBytes - b.sentBytes, a.sentPackets - b.sentPackets, a.receivedBytes - b.receivedBytes,
            a.receivedPackets - b.receivedPackets, a.longestDatagram};
  }
};

/// A connection to a server. The only place of the client that knows ENet.
class Connection {
 public:
  /// While a connection is being made the server is asked at least so often: it answers at once when it can be reached
  /// again.
  static constexpr Moment kBetweenCalls = std::chrono::milliseconds(500);

  enum class State { kConnecting, kConnected, kClosed };
  using Receiver = std::function<void(std::span<const std::uint8_t>)>;

  /// Begins to connect. Throws std::runtime_error when the host is not known or no socket can be had.
  Connection(const ServerAddress& server, Moment now);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Receives what has come and sends what is due, never waits. Every message goes to `receiver`.
  void service(Moment now, const Receiver& receiver);
  /// Sends what is queued.
  void flush(Moment now);
  /// Queues a message for the next `flush` or `service`. Without effect unless connected.
  void send(std::span<const std::uint8_t> message, bool reliable);
  /// Closes when all that was queued has arrived.
  void close();

  State state() const { return state_; }
  /// The server's address in numbers, for which no name has to be looked up.
  ServerAddress address() const;
  const Traffic& traffic() const { return traffic_; }

 private:
  struct DestroyHost {
    void operator()(ENetHost* host) const { enet_host_destroy(host); }
  };

  void handle(const ENetEvent& event, const Receiver& receiver);
  void keepUnthrottled();
  void keepCalling();
  void countTraffic();

  std::unique_ptr<ENetHost, DestroyHost> host_;
  ENetPeer* peer_ = nullptr;
  State state_ = State::kConnecting;
  Traffic traffic_;
};

}  // namespace platon
