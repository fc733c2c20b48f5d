#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "protocol/time.h"
#include "protocol/transport/noise.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// Longest datagram that server and client send, bytes of UDP payload. It passes through every usual network unsplit.
inline constexpr std::size_t kMaxDatagramBytes = 1200;

struct Datagram {
  SocketAddress peer;  ///< the sender
  ByteSpan bytes;      ///< may be empty; of a datagram that is too long, kMaxDatagramBytes + 1
};

/// Sends and receives datagrams: UDP, or a simulated network in tests. Nothing blocks, and whatever the network does is
/// a lost datagram, not an error.
class DatagramSocket {
 public:
  DatagramSocket() = default;
  virtual ~DatagramSocket() = default;
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  /// The next datagram; nothing if none waits. Its bytes are valid until the next call.
  virtual std::optional<Datagram> receive(Time now) = 0;
  /// Queues a datagram for `flush`, or sends it at once.
  virtual void send(const SocketAddress& receiver, ByteSpan bytes, Time now) = 0;
  virtual void flush(Time now) = 0;

  /// Waits until a datagram arrives, a signal is caught, or `timeout` has passed.
  virtual void wait(std::chrono::milliseconds timeout) = 0;
  /// The socket's own address.
  virtual SocketAddress address() const = 0;
};

/// Traffic of a socket: UDP payload.
struct Traffic {
  std::uint64_t sentBytes = 0;
  std::uint64_t sentPackets = 0;
  std::uint64_t receivedBytes = 0;
  std::uint64_t receivedPackets = 0;
  std::uint64_t longestDatagram = 0;  ///< sent or received, bytes

  void addSent(std::size_t bytes) {
    sentBytes += bytes;
    ++sentPackets;
    longestDatagram = std::max<std::uint64_t>(longestDatagram, bytes);
  }
  void addReceived(std::size_t bytes) {
    receivedBytes += bytes;
    ++receivedPackets;
    longestDatagram = std::max<std::uint64_t>(longestDatagram, bytes);
  }

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

/// A socket, and the traffic over it.
class CountedSocket {
 public:
  explicit CountedSocket(std::unique_ptr<DatagramSocket> socket) : socket_(std::move(socket)) {}

  std::optional<Datagram> receive(Time now) {
    std::optional<Datagram> datagram = socket_->receive(now);
    if (datagram) traffic_.addReceived(datagram->bytes.size());
    return datagram;
  }
  void send(const SocketAddress& receiver, ByteSpan bytes, Time now) {
    traffic_.addSent(bytes.size());
    socket_->send(receiver, bytes, now);
  }
  void flush(Time now) { socket_->flush(now); }

  DatagramSocket& socket() const { return *socket_; }
  const Traffic& traffic() const { return traffic_; }

 private:
  std::unique_ptr<DatagramSocket> socket_;
  Traffic traffic_;
};

}  // namespace platon
