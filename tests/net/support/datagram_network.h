#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "protocol/transport/datagram_socket.h"

namespace platon {

/// A network in memory: what one socket sends, the receiver's socket receives at once. It keeps a copy of everything.
class DatagramNetwork {
 public:
  struct Sent {
    SocketAddress from;
    SocketAddress to;
    Bytes bytes;
  };

  /// A socket at this address. The network must outlive it.
  std::unique_ptr<DatagramSocket> socket(const SocketAddress& own);
  /// Delivers a datagram with any sender, as an attacker can.
  void inject(const SocketAddress& from, const SocketAddress& to, ByteSpan bytes);

  /// All that sockets have sent, in order.
  const std::vector<Sent>& sent() const { return sent_; }
  /// Releases what was kept so far; call it often where a test runs for long.
  void forgetSent() { sent_.clear(); }
  std::size_t bytesTo(const SocketAddress& receiver) const;
  /// Decides which datagrams are delivered; by default all.
  void setFilter(std::function<bool(const Sent&)> filter) { filter_ = std::move(filter); }

 private:
  class Socket;
  struct Waiting {
    SocketAddress from;
    Bytes bytes;
  };

  std::map<SocketAddress, std::deque<Waiting>> waiting_;  // by receiver
  std::vector<Sent> sent_;
  std::function<bool(const Sent&)> filter_;
};

/// An address by its text, "192.0.2.1" or "2001:db8::1".
SocketAddress addressAt(std::string_view ip, std::uint16_t port);

}  // namespace platon
