#pragma once

#include <cstdint>
#include <span>

namespace platon {

/// Kind of a datagram, found before ENet reads it.
struct DatagramHead {
  enum class Kind {
    kInvalid,  ///< no client sends it
    kConnect,  ///< requests a connection
    kPeer,     ///< belongs to the connection `peer`
  };

  Kind kind = Kind::kInvalid;
  std::uint16_t peer = 0;
};

/// Checks the commands of a datagram in the layout of ENet 1.3 with a checksum; the checksum itself is not verified. A
/// datagram is invalid when its lengths do not match, when it has a command that only servers send, or when it uses
/// what no client needs and costs ENet memory: compression, or fragments, one of which makes ENet allocate 128 KiB.
DatagramHead checkDatagram(std::span<const std::uint8_t> datagram);

}  // namespace platon
