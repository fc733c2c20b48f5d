#include "tests/net/support/raw_content.h"

#include <arpa/inet.h>
#include <enet/enet.h>

#include <algorithm>
#include <cstring>

namespace platon {
namespace {

constexpr int kAcknowledged = ENET_PROTOCOL_COMMAND_FLAG_ACKNOWLEDGE;
constexpr std::uint8_t kNoChannel = 0xff;

template <class Command>
Bytes content(std::uint16_t peer, const Command& command, std::size_t dataBytes) {
  Bytes bytes(kCommandAt + sizeof command + dataBytes, 0x5a);
  const std::uint16_t head = htons(static_cast<std::uint16_t>(peer | ENET_PROTOCOL_HEADER_FLAG_SENT_TIME));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + kCommandAt, &command, sizeof command);
  return bytes;
}

template <class Command>
Command commandOf(int number, std::uint8_t channel, std::uint16_t sequence = 0) {
  Command command{};
  command.header.command = static_cast<enet_uint8>(number);
  command.header.channelID = channel;
  command.header.reliableSequenceNumber = htons(sequence);
  return command;
}

Bytes withData(Bytes bytes, ByteSpan data) {
  std::copy(data.begin(), data.end(), bytes.end() - static_cast<std::ptrdiff_t>(data.size()));
  return bytes;
}

}  // namespace

Bytes connectContent(std::uint32_t connectId) {
  auto command = commandOf<ENetProtocolConnect>(ENET_PROTOCOL_COMMAND_CONNECT | kAcknowledged, kNoChannel, 1);
  command.incomingSessionID = command.outgoingSessionID = 0xff;
  command.mtu = htonl(1400);
  command.windowSize = htonl(65536);
  command.channelCount = htonl(2);
  command.connectID = connectId;
  return content(ENET_PROTOCOL_MAXIMUM_PEER_ID, command, 0);
}

Bytes pingContent(std::uint16_t peer) {
  return content(peer, commandOf<ENetProtocolPing>(ENET_PROTOCOL_COMMAND_PING | kAcknowledged, kNoChannel), 0);
}

Bytes disconnectContent(std::uint16_t peer) {
  return content(peer, commandOf<ENetProtocolDisconnect>(ENET_PROTOCOL_COMMAND_DISCONNECT | kAcknowledged, kNoChannel),
                 0);
}

Bytes acknowledgeContent(std::uint16_t peer, std::uint16_t sequence, std::uint8_t channel, std::uint16_t time) {
  auto command = commandOf<ENetProtocolAcknowledge>(ENET_PROTOCOL_COMMAND_ACKNOWLEDGE, channel);
  command.receivedReliableSequenceNumber = htons(sequence);
  command.receivedSentTime = htons(time);
  return content(peer, command, 0);
}

Bytes unsequencedContent(std::uint16_t peer, std::uint16_t dataBytes) {
  auto command = commandOf<ENetProtocolSendUnsequenced>(
      ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED | int{ENET_PROTOCOL_COMMAND_FLAG_UNSEQUENCED}, 1);
  command.dataLength = htons(dataBytes);
  return content(peer, command, dataBytes);
}

Bytes reliableContent(std::uint16_t peer, std::uint16_t sequence, std::uint16_t dataBytes) {
  auto command = commandOf<ENetProtocolSendReliable>(ENET_PROTOCOL_COMMAND_SEND_RELIABLE | kAcknowledged, 0, sequence);
  command.dataLength = htons(dataBytes);
  return content(peer, command, dataBytes);
}

Bytes unsequencedContent(std::uint16_t peer, ByteSpan data) {
  return withData(unsequencedContent(peer, static_cast<std::uint16_t>(data.size())), data);
}

Bytes reliableContent(std::uint16_t peer, std::uint16_t sequence, ByteSpan data) {
  return withData(reliableContent(peer, sequence, static_cast<std::uint16_t>(data.size())), data);
}

std::uint16_t sentTimeOf(ByteSpan content) { return static_cast<std::uint16_t>(content[2] << 8 | content[3]); }

Bytes joinedContents(const std::vector<Bytes>& contents) {
  Bytes all = contents.front();
  for (std::size_t i = 1; i < contents.size(); ++i) {
    all.insert(all.end(), contents[i].begin() + kCommandAt, contents[i].end());
  }
  return all;
}

Bytes unreliableContent(std::uint16_t peer, std::uint16_t sequence) {
  auto command = commandOf<ENetProtocolSendUnreliable>(ENET_PROTOCOL_COMMAND_SEND_UNRELIABLE, 1, sequence);
  command.unreliableSequenceNumber = htons(sequence);
  return content(peer, command, 0);
}

Bytes fragmentContent(std::uint16_t peer) {
  auto command = commandOf<ENetProtocolSendFragment>(ENET_PROTOCOL_COMMAND_SEND_FRAGMENT | kAcknowledged, 0, 1);
  command.dataLength = htons(1);
  command.fragmentCount = htonl(ENET_PROTOCOL_MAXIMUM_FRAGMENT_COUNT);
  command.totalLength = htonl(8192);
  return content(peer, command, 1);
}

}  // namespace platon
