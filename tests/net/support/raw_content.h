#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "protocol/transport/noise.h"

namespace platon {

/// Offset of the first command in the contents below, after peer number and time.
inline constexpr std::size_t kCommandAt = 4;

/// Contents of sealed datagrams in ENet's format, to the connection `peer` of the receiver.
Bytes connectContent(std::uint32_t connectId);
Bytes pingContent(std::uint16_t peer);
Bytes disconnectContent(std::uint16_t peer);
/// `channel`: that of the acknowledged command, by default none. `time`: when it was sent, as sentTimeOf its content.
Bytes acknowledgeContent(std::uint16_t peer, std::uint16_t sequence, std::uint8_t channel = 0xff,
                         std::uint16_t time = 0);
Bytes unsequencedContent(std::uint16_t peer, std::uint16_t dataBytes);
Bytes reliableContent(std::uint16_t peer, std::uint16_t sequence, std::uint16_t dataBytes);
/// The same with these bytes as data.
Bytes unsequencedContent(std::uint16_t peer, ByteSpan data);
Bytes reliableContent(std::uint16_t peer, std::uint16_t sequence, ByteSpan data);
/// Milliseconds modulo 2^16 at the sender; the content must have a time.
std::uint16_t sentTimeOf(ByteSpan content);
/// The first content, and the commands of the others behind it.
Bytes joinedContents(const std::vector<Bytes>& contents);
/// An unreliable sequenced packet without data, which ENet would queue.
Bytes unreliableContent(std::uint16_t peer, std::uint16_t sequence);
/// The first of a million fragments of a message.
Bytes fragmentContent(std::uint16_t peer);

}  // namespace platon
