#pragma once

#include "protocol/transport/noise.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// A UDP socket on loopback that sends anything, also empty and too long datagrams, to one address.
class RawSocket {
 public:
  /// `own`: an address of 127.0.0.0/8 from which it sends. Throws std::runtime_error.
  explicit RawSocket(const SocketAddress& target, const char* own = "127.0.0.1");
  ~RawSocket();
  RawSocket(const RawSocket&) = delete;
  RawSocket& operator=(const RawSocket&) = delete;

  void send(ByteSpan datagram) const;
  /// The next datagram that has arrived; empty if there is none.
  Bytes receive() const;

 private:
  int socket_;
};

}  // namespace platon
