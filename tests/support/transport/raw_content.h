#pragma once

#include <cstddef>
#include <cstdint>

#include "protocol/transport/noise.h"

namespace platon {

/// Offset of the first command in the contents below, after peer number and time.
inline constexpr std::size_t kCommandAt = 4;

/// Contents of sealed datagrams in ENet's format, to the connection `peer` of the receiver.
Bytes connectContent(std::uint32_t connectId);
Bytes pingContent(std::uint16_t peer);
Bytes disconnectContent(std::uint16_t peer);
Bytes acknowledgeContent(std::uint16_t peer, std::uint16_t sequence);
Bytes unsequencedContent(std::uint16_t peer, std::uint16_t dataBytes);
Bytes reliableContent(std::uint16_t peer, std::uint16_t sequence, std::uint16_t dataBytes);
/// An unreliable sequenced packet without data, which ENet would queue.
Bytes unreliableContent(std::uint16_t peer, std::uint16_t sequence);
/// The first of a million fragments of a message.
Bytes fragmentContent(std::uint16_t peer);

}  // namespace platon
