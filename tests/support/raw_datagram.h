#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace platon {

using Bytes = std::vector<std::uint8_t>;

/// Offset of the first command in the datagrams below, after peer number, time and checksum.
inline constexpr std::size_t kCommandAt = 8;

/// Datagrams in ENet's format. The checksum is valid for a connection with this id, 0 for one that is requested.
Bytes connectDatagram(std::uint32_t connectId);
Bytes pingDatagram(std::uint16_t peer, std::uint32_t connectId = 0);
Bytes unsequencedDatagram(std::uint16_t peer, std::uint16_t dataBytes, std::uint32_t connectId = 0);
/// The first of a million fragments of a message.
Bytes fragmentDatagram(std::uint16_t peer, std::uint32_t connectId = 0);

/// A UDP socket on loopback that sends to a port of loopback.
class RawSocket {
 public:
  explicit RawSocket(std::uint16_t targetPort);
  ~RawSocket();
  RawSocket(const RawSocket&) = delete;
  RawSocket& operator=(const RawSocket&) = delete;

  void send(std::span<const std::uint8_t> datagram) const;

 private:
  int socket_;
};

}  // namespace platon
