#include "tests/support/raw_datagram.h"

#include <arpa/inet.h>
#include <enet/enet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

namespace platon {
namespace {

template <class Command>
Bytes datagram(std::uint16_t peer, std::uint32_t connectId, const Command& command, std::size_t dataBytes) {
  Bytes bytes(kCommandAt + sizeof command + dataBytes);
  const std::uint16_t head = htons(static_cast<std::uint16_t>(peer | ENET_PROTOCOL_HEADER_FLAG_SENT_TIME));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + 4, &connectId, sizeof connectId);
  std::memcpy(bytes.data() + kCommandAt, &command, sizeof command);
  const ENetBuffer buffer{bytes.data(), bytes.size()};
  const enet_uint32 checksum = enet_crc32(&buffer, 1);
  std::memcpy(bytes.data() + 4, &checksum, sizeof checksum);
  return bytes;
}

template <class Command>
Command commandOf(int number, std::uint8_t channel) {
  Command command{};
  command.header.command = static_cast<enet_uint8>(number);
  command.header.channelID = channel;
  return command;
}

}  // namespace

Bytes connectDatagram(std::uint32_t connectId) {
  auto command =
      commandOf<ENetProtocolConnect>(ENET_PROTOCOL_COMMAND_CONNECT | int{ENET_PROTOCOL_COMMAND_FLAG_ACKNOWLEDGE}, 0xff);
  command.header.reliableSequenceNumber = htons(1);
  command.incomingSessionID = command.outgoingSessionID = 0xff;
  command.mtu = htonl(1400);
  command.windowSize = htonl(65536);
  command.channelCount = htonl(2);
  command.connectID = connectId;
  return datagram(ENET_PROTOCOL_MAXIMUM_PEER_ID, 0, command, 0);
}

Bytes pingDatagram(std::uint16_t peer, std::uint32_t connectId) {
  return datagram(peer, connectId, commandOf<ENetProtocolPing>(ENET_PROTOCOL_COMMAND_PING, 0xff), 0);
}

Bytes unsequencedDatagram(std::uint16_t peer, std::uint16_t dataBytes, std::uint32_t connectId) {
  auto command = commandOf<ENetProtocolSendUnsequenced>(ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED, 1);
  command.dataLength = htons(dataBytes);
  return datagram(peer, connectId, command, dataBytes);
}

Bytes fragmentDatagram(std::uint16_t peer, std::uint32_t connectId) {
  auto command = commandOf<ENetProtocolSendFragment>(ENET_PROTOCOL_COMMAND_SEND_FRAGMENT, 0);
  command.dataLength = htons(1);
  command.fragmentCount = htonl(ENET_PROTOCOL_MAXIMUM_FRAGMENT_COUNT);
  command.totalLength = htonl(8192);
  return datagram(peer, connectId, command, 1);
}

RawSocket::RawSocket(std::uint16_t targetPort) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
  sockaddr_in target{};
  target.sin_family = AF_INET;
  target.sin_port = htons(targetPort);
  target.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&target), sizeof target) != 0) {
    throw std::runtime_error("no socket on loopback");
  }
}

RawSocket::~RawSocket() { close(socket_); }

void RawSocket::send(std::span<const std::uint8_t> datagram) const {
  ::send(socket_, datagram.data(), datagram.size(), 0);
}

}  // namespace platon
