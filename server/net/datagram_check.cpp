#include "server/net/datagram_check.h"

#include <enet/enet.h>

#include <cstddef>
#include <optional>

namespace platon {
namespace {

using Bytes = std::span<const std::uint8_t>;

// Reads a number in network byte order.
std::uint16_t read16(Bytes bytes, std::size_t offset) {
  return static_cast<std::uint16_t>(bytes[offset] << 8 | bytes[offset + 1]);
}

/// Offset of the field with the number of data bytes after the command; 0 for a command without data, nothing for one
/// that a client must not send.
std::optional<std::size_t> lengthOffset(std::uint8_t command) {
  switch (command) {
    case ENET_PROTOCOL_COMMAND_ACKNOWLEDGE:
    case ENET_PROTOCOL_COMMAND_CONNECT:
    case ENET_PROTOCOL_COMMAND_DISCONNECT:
    case ENET_PROTOCOL_COMMAND_PING:
    case ENET_PROTOCOL_COMMAND_BANDWIDTH_LIMIT:
    case ENET_PROTOCOL_COMMAND_THROTTLE_CONFIGURE:
      return 0;
    case ENET_PROTOCOL_COMMAND_SEND_RELIABLE:
      return offsetof(ENetProtocolSendReliable, dataLength);
    case ENET_PROTOCOL_COMMAND_SEND_UNRELIABLE:
      return offsetof(ENetProtocolSendUnreliable, dataLength);
    case ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED:
      return offsetof(ENetProtocolSendUnsequenced, dataLength);
    default:
      return std::nullopt;
  }
}

/// Length of the first command with its data; 0 when it is invalid.
std::size_t commandBytes(Bytes commands) {
  const auto command = static_cast<std::uint8_t>(commands[0] & ENET_PROTOCOL_COMMAND_MASK);
  const auto offset = lengthOffset(command);
  if (!offset) return 0;
  const std::size_t fixed = enet_protocol_command_size(command);
  if (commands.size() < fixed) return 0;
  const std::size_t data = *offset == 0 ? 0 : read16(commands, *offset);
  return fixed + data <= commands.size() ? fixed + data : 0;
}

bool areCommands(Bytes commands) {
  while (!commands.empty()) {
    const std::size_t bytes = commandBytes(commands);
    if (bytes == 0) return false;
    commands = commands.subspan(bytes);
  }
  return true;
}

bool isConnect(Bytes commands) {
  return (commands[0] & ENET_PROTOCOL_COMMAND_MASK) == ENET_PROTOCOL_COMMAND_CONNECT &&
         commands.size() == sizeof(ENetProtocolConnect);
}

}  // namespace

DatagramHead checkDatagram(Bytes datagram) {
  constexpr std::size_t checksumBytes = sizeof(enet_uint32);
  if (datagram.size() < sizeof(std::uint16_t)) return {};
  const std::uint16_t head = read16(datagram, 0);
  const bool timed = (head & ENET_PROTOCOL_HEADER_FLAG_SENT_TIME) != 0;
  const std::size_t headBytes = (timed ? sizeof(ENetProtocolHeader) : sizeof(std::uint16_t)) + checksumBytes;
  if ((head & ENET_PROTOCOL_HEADER_FLAG_COMPRESSED) != 0 || datagram.size() <= headBytes) return {};
  const Bytes commands = datagram.subspan(headBytes);
  if (!areCommands(commands)) return {};
  const std::uint16_t peer = head & ENET_PROTOCOL_MAXIMUM_PEER_ID;
  if (peer != ENET_PROTOCOL_MAXIMUM_PEER_ID) return {DatagramHead::Kind::kPeer, peer};
  return {isConnect(commands) ? DatagramHead::Kind::kConnect : DatagramHead::Kind::kInvalid, peer};
}

}  // namespace platon
