#include "tests/fuzz/enet_content.h"

#include <array>
#include <optional>
#include <vector>

namespace platon::fuzz {
namespace {

constexpr std::uint16_t kNobody = 0xfff;
constexpr std::uint16_t kTimed = 0x8000;
constexpr std::uint16_t kCompressed = 0x4000;
constexpr std::uint8_t kConnection = 0xff;  // channel
constexpr std::uint8_t kAny = 0xfe;
constexpr std::size_t kMaxMessage = 1152;

/// A command of our programs.
struct Command {
  std::uint8_t number;
  std::uint8_t flags;  // kAny: any
  std::uint8_t channel;
  std::size_t bytes;     // without data
  std::size_t lengthAt;  // 0: no data
  bool ofClient = true;
  bool ofServer = true;
};

constexpr std::uint8_t kConnect = 2;
constexpr std::uint8_t kAcknowledge = 1;
constexpr std::array kCommands{
    Command{kAcknowledge, 0, kAny, 8, 0},
    Command{kConnect, 0x80, kConnection, 48, 0, true, false},
    Command{3, 0x80, kConnection, 44, 0, false, true},
    Command{4, kAny, kConnection, 8, 0},
    Command{5, 0x80, kConnection, 4, 0},
    Command{6, 0x80, 0, 6, 4},
    Command{9, 0x40, 1, 8, 6},
};

std::uint16_t read(ByteSpan bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] << 8 | bytes[at + 1]);
}

/// The content of a datagram by the page.
struct Reading {
  std::uint16_t peer = 0;
  std::vector<EnetCommand> commands;
};

// Bytes of the first command with its data; nothing if our programs do not send it.
std::optional<std::size_t> commandBytes(ByteSpan rest, EnetSender sender) {
  for (const Command& each : kCommands) {
    if (each.number != rest[0] % 16 || rest.size() < each.bytes) continue;
    const bool ofSender = sender == EnetSender::kClient ? each.ofClient : each.ofServer;
    const bool flagsFit = each.flags == kAny || each.flags == (rest[0] & 0xf0);
    if (!ofSender || !flagsFit || (each.channel != kAny && each.channel != rest[1])) return std::nullopt;
    if (each.lengthAt == 0) return each.bytes;
    const std::size_t data = read(rest, each.lengthAt);
    if (data == 0 || data > kMaxMessage || each.bytes + data > rest.size()) return std::nullopt;
    return each.bytes + data;
  }
  return std::nullopt;
}

bool isWhole(const Reading& reading, EnetSender sender) {
  std::size_t connects = 0;
  std::size_t spoken = 0;
  for (const EnetCommand& each : reading.commands) {
    connects += each.command == kConnect ? 1 : 0;
    spoken += each.command != kAcknowledge ? 1 : 0;
  }
  if (reading.commands.empty() || reading.commands.size() > 32) return false;
  if (sender == EnetSender::kClient && spoken > 16) return false;
  return reading.peer == kNobody ? connects == 1 && reading.commands.size() == 1 : connects == 0;
}

std::optional<Reading> readContent(ByteSpan content, EnetSender sender) {
  if (content.size() < 2 || (read(content, 0) & kCompressed) != 0) return std::nullopt;
  const std::size_t head = (read(content, 0) & kTimed) != 0 ? 4 : 2;
  if (content.size() < head) return std::nullopt;
  Reading reading{static_cast<std::uint16_t>(read(content, 0) & kNobody), {}};
  for (ByteSpan rest = content.subspan(head); !rest.empty();) {
    const std::optional<std::size_t> bytes = rest.size() < 4 ? std::nullopt : commandBytes(rest, sender);
    if (!bytes) return std::nullopt;
    const auto number = static_cast<std::uint8_t>(rest[0] % 16);
    const std::size_t sequenceAt = number == kAcknowledge ? 4 : 2;
    reading.commands.push_back({number, rest[1], read(rest, sequenceAt),
                                static_cast<std::uint16_t>(content.size() - rest.size()),
                                static_cast<std::uint16_t>(*bytes)});
    rest = rest.subspan(*bytes);
  }
  return isWhole(reading, sender) ? std::optional(reading) : std::nullopt;
}

void append(platon::Bytes& content, std::uint16_t number) {
  content.push_back(static_cast<std::uint8_t>(number >> 8));
  content.push_back(static_cast<std::uint8_t>(number));
}

void appendCommand(platon::Bytes& content, const Command& command, ByteSource& bytes) {
  const std::size_t begin = content.size();
  content.push_back(static_cast<std::uint8_t>(command.number | (command.flags == kAny ? 0x80 : command.flags)));
  content.push_back(command.channel == kAny ? bytes.byte() : command.channel);
  append(content, static_cast<std::uint16_t>(bytes.byte()));
  content.resize(begin + command.bytes, 0x5a);
  if (command.lengthAt == 0) return;
  const std::size_t data = bytes.below(5) == 0 ? bytes.below(1200) : bytes.below(20);
  content[begin + command.lengthAt] = static_cast<std::uint8_t>(data >> 8);
  content[begin + command.lengthAt + 1] = static_cast<std::uint8_t>(data);
  content.resize(content.size() + data, 0xa5);
}

}  // namespace

platon::Bytes enetContent(ByteSource& bytes, EnetSender sender) {
  platon::Bytes content;
  const bool connects = bytes.below(8) == 0;
  const std::size_t peer = connects ? kNobody : bytes.below(3);
  append(content, static_cast<std::uint16_t>(peer | (bytes.flag() ? kTimed : 0)));
  if (read(content, 0) >= kTimed) append(content, 1000);
  const std::size_t count = connects ? 1 : bytes.below(40);
  for (std::size_t i = 0; i < count; ++i) {
    const Command& command = kCommands[connects ? 1 : bytes.below(kCommands.size())];
    const bool ofSender = sender == EnetSender::kClient ? command.ofClient : command.ofServer;
    if ((ofSender && (connects || command.number != kConnect)) || bytes.below(16) == 0) {
      appendCommand(content, command, bytes);
    }
  }
  for (std::size_t changed = bytes.below(4); changed > 1; --changed)
    content[bytes.below(content.size())] = bytes.byte();
  return content;
}

std::string enetContentFault(ByteSpan content, EnetSender sender) {
  const std::optional<Reading> expected = readContent(content, sender);
  const std::optional<EnetCommands> found = readEnetCommands(content, sender);
  if (expected.has_value() != found.has_value()) {
    return expected ? "a content that our programs send is refused" : "a content that our programs do not send passes";
  }
  if (!found) return {};
  bool same = found->peer == expected->peer && found->count == expected->commands.size();
  for (std::size_t i = 0; same && i < found->count; ++i) {
    const EnetCommand& one = found->commands[i];
    const EnetCommand& other = expected->commands[i];
    same = one.command == other.command && one.channel == other.channel && one.sequence == other.sequence &&
           one.offset == other.offset && one.bytes == other.bytes;
  }
  return same ? std::string() : "the commands of a content are read wrongly";
}

}  // namespace platon::fuzz
