#include "protocol/transport/enet_layer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include "protocol/limits.h"

namespace platon {
namespace {

thread_local EnetPort* currentPort = nullptr;
thread_local enet_uint32 currentTime = 0;

/// Receives nothing and notes whether it was asked.
class Probe : public EnetPort {
 public:
  void sendFromEnet(const ENetAddress&, ByteSpan) override { sent_ = true; }
  std::optional<Received> receiveForEnet() override {
    asked_ = true;
    return std::nullopt;
  }
  bool wasUsed() const { return sent_ && asked_; }

 private:
  bool sent_ = false;
  bool asked_ = false;
};

}  // namespace

EnetScope::EnetScope(EnetPort& port, Time now) : outer_(currentPort), outerTime_(currentTime) {
  currentPort = &port;
  currentTime = static_cast<enet_uint32>(now / std::chrono::milliseconds(1));
}

EnetScope::~EnetScope() {
  currentPort = outer_;
  currentTime = outerTime_;
}

bool enetUsesOurCalls() {
  Probe probe;
  constexpr Time kTime = std::chrono::milliseconds(12345);
  const EnetScope scope(probe, kTime);
  ENetHost* const host = enet_host_create(nullptr, 1, 1, 0, 0);
  if (host == nullptr) return true;  // there is no socket; the cause is found when a connection is made
  const ENetAddress nobody{1, 1};
  enet_host_connect(host, &nobody, 1, 0);
  enet_host_service(host, nullptr, 0);
  const bool used = probe.wasUsed() && host->serviceTime == 12345;
  enet_host_destroy(host);
  return used;
}

namespace {

// A sender has at most so many reliable commands on the way; see kMaxQueuedMessages.
constexpr std::uint16_t kMaxAhead = 256;
constexpr std::uint16_t kMaxBehind = 0x4000;
constexpr std::uint8_t kNoChannel = 0xff;  // of commands that belong to the connection

// Reads a number in network byte order.
std::uint16_t read16(ByteSpan bytes, std::size_t offset) {
  return static_cast<std::uint16_t>(bytes[offset] << 8 | bytes[offset + 1]);
}

// Flags, channel and data length that a command of our programs has.
struct Form {
  std::uint8_t flags;
  std::optional<std::uint8_t> channel;        // nothing: any
  std::optional<std::size_t> lengthOffset{};  // of the number of data bytes
};

std::optional<Form> formOf(std::uint8_t command, EnetSender sender) {
  constexpr std::uint8_t acknowledged = ENET_PROTOCOL_COMMAND_FLAG_ACKNOWLEDGE;
  switch (command) {
    case ENET_PROTOCOL_COMMAND_ACKNOWLEDGE:
      return Form{0, std::nullopt};
    case ENET_PROTOCOL_COMMAND_CONNECT:
      if (sender == EnetSender::kServer) return std::nullopt;
      return Form{acknowledged, kNoChannel};
    case ENET_PROTOCOL_COMMAND_VERIFY_CONNECT:
      if (sender == EnetSender::kClient) return std::nullopt;
      return Form{acknowledged, kNoChannel};
    case ENET_PROTOCOL_COMMAND_PING:
      return Form{acknowledged, kNoChannel};
    case ENET_PROTOCOL_COMMAND_SEND_RELIABLE:
      return Form{acknowledged, kReliableChannel, offsetof(ENetProtocolSendReliable, dataLength)};
    case ENET_PROTOCOL_COMMAND_SEND_UNSEQUENCED:
      return Form{ENET_PROTOCOL_COMMAND_FLAG_UNSEQUENCED, kTickChannel,
                  offsetof(ENetProtocolSendUnsequenced, dataLength)};
    default:
      return std::nullopt;
  }
}

// ENet disconnects with an acknowledged command, or without one when it has given up.
bool isDisconnect(std::uint8_t byte, std::uint8_t channel) {
  return (byte & ENET_PROTOCOL_COMMAND_MASK) == ENET_PROTOCOL_COMMAND_DISCONNECT && channel == kNoChannel;
}

bool hasForm(std::uint8_t byte, std::uint8_t channel, const Form& form) {
  return (byte & ~ENET_PROTOCOL_COMMAND_MASK) == form.flags && (!form.channel || *form.channel == channel);
}

/// Length of the first command with its data; 0 if it is not allowed.
std::size_t commandBytes(ByteSpan bytes, EnetSender sender) {
  const auto command = static_cast<std::uint8_t>(bytes[0] & ENET_PROTOCOL_COMMAND_MASK);
  const std::size_t fixed = enet_protocol_command_size(command);
  if (fixed < sizeof(ENetProtocolCommandHeader) || bytes.size() < fixed) return 0;
  if (isDisconnect(bytes[0], bytes[1])) return fixed;
  const std::optional<Form> form = formOf(command, sender);
  if (!form || !hasForm(bytes[0], bytes[1], *form)) return 0;
  if (!form->lengthOffset) return fixed;
  const std::size_t data = read16(bytes, *form->lengthOffset);
  return data != 0 && data <= kMaxMessageBytes && data <= bytes.size() - fixed ? fixed + data : 0;
}

std::uint16_t sequenceOf(ByteSpan command) {
  const bool acknowledges = (command[0] & ENET_PROTOCOL_COMMAND_MASK) == ENET_PROTOCOL_COMMAND_ACKNOWLEDGE;
  return read16(command, acknowledges ? offsetof(ENetProtocolAcknowledge, receivedReliableSequenceNumber)
                                      : offsetof(ENetProtocolCommandHeader, reliableSequenceNumber));
}

enet_uint32 connectIdOf(ByteSpan connect) {
  enet_uint32 id = 0;
  std::memcpy(&id, connect.data() + offsetof(ENetProtocolConnect, connectID), sizeof id);
  return id;
}

// Whether a command of this number is outstanding.
bool isOutstanding(const ENetPeer& sender, std::uint8_t channel, std::uint16_t sequence) {
  bool found = false;
  forEachOutstanding(sender, [&](const ENetOutgoingCommand& each) {
    found = found || (each.command.header.channelID == channel && each.reliableSequenceNumber == sequence);
  });
  return found;
}

// Whether one of the commands acknowledges the same.
bool acknowledges(const EnetCommands& commands, const EnetCommand& acknowledgement) {
  const auto end = commands.commands.begin() + static_cast<std::ptrdiff_t>(commands.count);
  return std::any_of(commands.commands.begin(), end, [&](const EnetCommand& each) {
    return each.command == acknowledgement.command && each.channel == acknowledgement.channel &&
           each.sequence == acknowledgement.sequence;
  });
}

}  // namespace

std::optional<EnetCommands> readEnetCommands(ByteSpan content, EnetSender sender) {
  std::size_t spoken = 0;  // commands that are not acknowledgements
  bool connects = false;
  if (content.size() < sizeof(std::uint16_t)) return std::nullopt;
  const std::uint16_t head = read16(content, 0);
  const bool timed = (head & ENET_PROTOCOL_HEADER_FLAG_SENT_TIME) != 0;
  const std::size_t headBytes = timed ? sizeof(ENetProtocolHeader) : sizeof(std::uint16_t);
  if ((head & ENET_PROTOCOL_HEADER_FLAG_COMPRESSED) != 0 || content.size() <= headBytes) return std::nullopt;
  EnetCommands found;
  found.peer = head & ENET_PROTOCOL_MAXIMUM_PEER_ID;
  for (ByteSpan rest = content.subspan(headBytes); !rest.empty();) {
    if (found.count == EnetCommands::kMaxCommands) return std::nullopt;
    const std::size_t bytes = commandBytes(rest, sender);
    if (bytes == 0) return std::nullopt;
    const auto command = static_cast<std::uint8_t>(rest[0] & ENET_PROTOCOL_COMMAND_MASK);
    if (command == ENET_PROTOCOL_COMMAND_CONNECT) found.connectId = connectIdOf(rest);
    spoken += command != ENET_PROTOCOL_COMMAND_ACKNOWLEDGE ? 1 : 0;
    connects = connects || command == ENET_PROTOCOL_COMMAND_CONNECT;
    const auto offset = static_cast<std::uint16_t>(content.size() - rest.size());
    found.commands[found.count++] = {command, rest[1], sequenceOf(rest), offset, static_cast<std::uint16_t>(bytes)};
    rest = rest.subspan(bytes);
  }
  if (sender == EnetSender::kClient && spoken > EnetCommands::kMaxOfClient) return std::nullopt;
  const bool isUnconnected = found.peer == ENET_PROTOCOL_MAXIMUM_PEER_ID;
  if (connects != isUnconnected || (isUnconnected && found.count != 1)) return std::nullopt;
  return found;
}

bool areSequencesNear(const EnetCommands& commands, const ENetPeer& receiver) {
  if (receiver.channelCount == 0) return true;
  for (std::size_t i = 0; i < commands.count; ++i) {
    const EnetCommand& command = commands.commands[i];
    if (command.command != ENET_PROTOCOL_COMMAND_SEND_RELIABLE) continue;
    if (command.channel >= receiver.channelCount) return false;
    const std::uint16_t arrived = receiver.channels[command.channel].incomingReliableSequenceNumber;
    const auto ahead = static_cast<std::uint16_t>(command.sequence - arrived);
    if (ahead > kMaxAhead && ahead < static_cast<std::uint16_t>(-kMaxBehind)) return false;
  }
  return true;
}

std::size_t bytesOf(const ENetOutgoingCommand& command) {
  return enet_protocol_command_size(command.command.header.command) + command.fragmentLength;
}

void removeFalseAcknowledgements(Bytes& content, EnetCommands& commands, const ENetPeer& receiver) {
  const EnetCommands all = commands;
  const Bytes from = std::move(content);
  content.assign(from.begin(), from.begin() + all.commands[0].offset);
  commands.count = 0;
  for (const EnetCommand& each : std::span(all.commands).first(all.count)) {
    const bool isFalse = each.command == ENET_PROTOCOL_COMMAND_ACKNOWLEDGE &&
                         (!isOutstanding(receiver, each.channel, each.sequence) || acknowledges(commands, each));
    if (isFalse) continue;
    commands.commands[commands.count] = each;
    commands.commands[commands.count++].offset = static_cast<std::uint16_t>(content.size());
    content.insert(content.end(), from.begin() + each.offset, from.begin() + each.offset + each.bytes);
  }
}

}  // namespace platon

extern "C" {

int enet_socket_send(ENetSocket, const ENetAddress* address, const ENetBuffer* buffers, size_t bufferCount) {
  assert(platon::currentPort != nullptr && address != nullptr);
  std::array<std::uint8_t, ENET_PROTOCOL_MAXIMUM_MTU> datagram;
  std::size_t size = 0;
  for (size_t i = 0; i < bufferCount; ++i) {
    if (buffers[i].dataLength > datagram.size() - size) return -1;
    std::memcpy(datagram.data() + size, buffers[i].data, buffers[i].dataLength);
    size += buffers[i].dataLength;
  }
  platon::currentPort->sendFromEnet(*address, platon::ByteSpan(datagram).first(size));
  return static_cast<int>(size);
}

// ENet takes 0 for "nothing waits".
int enet_socket_receive(ENetSocket, ENetAddress* address, ENetBuffer* buffers, size_t bufferCount) {
  assert(platon::currentPort != nullptr && bufferCount == 1);
  (void)bufferCount;
  const auto received = platon::currentPort->receiveForEnet();
  if (!received || received->bytes.size() > buffers[0].dataLength) return 0;
  std::memcpy(buffers[0].data, received->bytes.data(), received->bytes.size());
  *address = received->session;
  return static_cast<int>(received->bytes.size());
}

enet_uint32 enet_time_get() { return platon::currentTime; }

}  // extern "C"
