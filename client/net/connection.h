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

/// Network traffic: UDP payload, acknowledgements and retransmissions included.
struct Traffic {
  std::uint64_t sentBytes = 0;
  std::uint64_t sentPackets = 0;
  std::uint64_t receivedBytes = 0;
  std::uint64_t receivedPackets = 0;
  std::uint64_t longestDatagram = 0;  ///< sent or received, bytes

  friend Traffic operator+(const Traffic& a, const Traffic& b) {
    return {a.sentBytes + b.sentBytes, a.sentPackets + b.sentPackets, a.receivedBytes + b.receivedBytes,
            a.receivedPackets + b.receivedPackets, std::max(a.longestDatagram, b.longestDatagram)};
  }
  /// Traffic gained from the earlier count `b` to the later count `a`; `longestDatagram` is that of `a`.
  friend Traffic operator-(const Traffic& a, const Traffic& b) {
    return {a.sentBytes - b.sentBytes, a.sentPackets - b.sentPackets, a.receivedBytes - b.receivedBytes,
            a.receivedPackets - b.receivedPackets, a.longestDatagram};
  }
};

/// A connection to a server over ENet. The only class of the client that calls ENet.
class Connection {
 public:
  /// Longest pause between two connection requests.
  static constexpr Moment kRequestInterval = std::chrono::milliseconds(500);
  /// Messages that one `service` delivers at most; further ones wait for the next call.
  static constexpr std::uint32_t kMaxMessagesPerService = 512;

  enum class State { kConnecting, kConnected, kClosed };
  using Receiver = std::function<void(std::span<const std::uint8_t>)>;

  /// Starts to connect. Throws std::runtime_error if the host name cannot be resolved or no socket is available.
  Connection(const ServerAddress& server, Moment now);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Passes received messages to `receiver` and sends queued datagrams. Does not block.
  void service(Moment now, const Receiver& receiver);
  /// Sends the queued messages.
  void flush(Moment now);
  /// Queues a message for the next `flush` or `service`. No effect unless connected.
  void send(std::span<const std::uint8_t> message, bool reliable);
  /// Closes the connection once all queued messages have been acknowledged.
  void close();

  State state() const { return state_; }
  /// The server's resolved address: an IPv4 address instead of a host name.
  ServerAddress address() const;
  const Traffic& traffic() const { return traffic_; }

 private:
  struct DestroyHost {
    void operator()(ENetHost* host) const { enet_host_destroy(host); }
  };

  void handle(const ENetEvent& event, const Receiver& receiver);
  void disableThrottle();
  void limitRequestInterval();
  void countTraffic();

  std::unique_ptr<ENetHost, DestroyHost> host_;
  ENetPeer* peer_ = nullptr;
  State state_ = State::kConnecting;
  Traffic traffic_;
};

}  // namespace platon
