#pragma once

#include <cstdint>
#include <span>

namespace platon {

/// What a datagram is before ENet reads it.
struct DatagramHead {
  enum class Kind {
    kBroken,   ///< nothing that a client of ours would send
    kConnect,  ///< asks for a connection
    kPeer,     ///< for the connection `peer`
  };

  Kind kind = Kind::kBroken;
  std::uint16_t peer = 0;
};

/// Walks over the commands of a datagram with a checksum, as ENet 1.3 lays them out, without looking at the checksum.
/// Broken is what does not fit its own lengths, what only a server sends, and what a client never needs but costs
/// ENet memory: compression, and fragments, of which a single one makes ENet allocate 128 KiB.
DatagramHead checkDatagram(std::span<const std::uint8_t> datagram);

}  // namespace platon
