#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "protocol/transport/datagram_socket.h"

namespace platon {

/// Stands between a server and its socket and moves datagrams only when told, so that the memory of a simulated network
/// is not taken for the server's.
class BufferedSocket : public DatagramSocket {
 public:
  explicit BufferedSocket(std::unique_ptr<DatagramSocket> inner) : inner_(std::move(inner)), sent_(kMaxSent) {}

  /// Fetches what has arrived.
  void fetch(Time now) {
    arrived_.clear();
    next_ = 0;
    while (const auto datagram = inner_->receive(now)) {
      arrived_.push_back({datagram->peer, {datagram->bytes.begin(), datagram->bytes.end()}});
    }
  }
  /// Passes on what was sent, and tells it to `note`.
  template <class Note>
  void deliver(Time now, Note note) {
    for (const Sent& each : std::span(sent_).first(waiting_)) {
      const ByteSpan bytes = ByteSpan(each.bytes).first(each.size);
      note(each.receiver, bytes);
      inner_->send(each.receiver, bytes, now);
    }
    waiting_ = 0;
  }

  std::optional<Datagram> receive(Time) override {
    if (next_ == arrived_.size()) return std::nullopt;
    const Arrived& datagram = arrived_[next_++];
    return Datagram{datagram.sender, datagram.bytes};
  }
  /// Beyond kMaxSent, datagrams are lost.
  void send(const SocketAddress& receiver, ByteSpan bytes, Time) override {
    if (waiting_ == kMaxSent) return;
    Sent& datagram = sent_[waiting_++];
    datagram.receiver = receiver;
    datagram.size = bytes.size();
    std::copy(bytes.begin(), bytes.end(), datagram.bytes.begin());
  }
  void flush(Time) override {}
  void wait(std::chrono::milliseconds) override {}
  SocketAddress address() const override { return inner_->address(); }

 private:
  static constexpr std::size_t kMaxSent = 4096;  // between two calls of `deliver`
  struct Arrived {
    SocketAddress sender;
    Bytes bytes;
  };
  struct Sent {
    SocketAddress receiver;
    std::array<std::uint8_t, kMaxDatagramBytes> bytes;
    std::size_t size = 0;
  };

  std::unique_ptr<DatagramSocket> inner_;
  std::vector<Arrived> arrived_;
  std::size_t next_ = 0;  // in arrived_
  std::vector<Sent> sent_;
  std::size_t waiting_ = 0;  // in sent_
};

}  // namespace platon
