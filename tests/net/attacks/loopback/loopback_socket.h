#pragma once

#include <optional>

#include "protocol/transport/datagram_socket.h"

namespace platon {

/// A UDP socket that sends anything, also empty datagrams, in the name of any address of this machine, and of those of
/// 127.0.0.0/8 in particular. It is one of IPv4 or of IPv6.
class LoopbackSocket {
 public:
  /// At a free port of `own`; of all addresses if it is 0.0.0.0 or ::. Throws std::runtime_error.
  explicit LoopbackSocket(const IpAddress& own);
  ~LoopbackSocket();
  LoopbackSocket(const LoopbackSocket&) = delete;
  LoopbackSocket& operator=(const LoopbackSocket&) = delete;

  void send(const SocketAddress& receiver, ByteSpan datagram) const;
  /// The same in the name of `from`, with this socket's port.
  void sendFrom(const IpAddress& from, const SocketAddress& receiver, ByteSpan datagram) const;
  /// The next datagram; nothing if none waits. Its bytes are valid until the next call.
  std::optional<Datagram> receive();
  SocketAddress address() const;

 private:
  void sendMessage(const SocketAddress& receiver, ByteSpan datagram, std::span<char> control) const;

  bool ipv6_;
  int handle_;
  Bytes buffer_;
};

}  // namespace platon
