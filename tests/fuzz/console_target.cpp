#include <algorithm>
#include <utility>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "server/admin/bans.h"
#include "server/admin/console.h"
#include "server/admin/console_socket.h"
#include "server/admin/metrics.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

constexpr std::size_t kMaxSentenceBytes = 300;

/// Whether the values of a command are within the limits that the rest of the server expects.
struct Acceptable {
  bool operator()(const KickCommand& command) const {
    return !command.player.text.empty() && isLabel(command.reason, kMaxKickReasonBytes);
  }
  bool operator()(const MuteCommand& command) const { return !command.player.text.empty(); }
  bool operator()(const SayCommand& command) const {
    return !command.text.empty() && isLabel(command.text, kMaxReasonBytes);
  }
  bool operator()(const UnbanCommand& command) const {
    return std::get<AddressRange>(AddressRange::parse(command.range.text())) == command.range;
  }
  // A ban can be written to the file and read again.
  bool operator()(const BanCommand& command) const {
    const auto* range = std::get_if<AddressRange>(&command.target);
    BanList list;
    list.add({range ? *range : AddressRange(IpAddress{}), std::nullopt, command.reason});
    const auto again = BanList::parse(list.text());
    return std::holds_alternative<BanList>(again) && std::get<BanList>(again) == list;
  }
  template <class Command>
  bool operator()(const Command&) const {
    return true;
  }
};

std::string lineFault(const std::string& line) {
  const auto parsed = parseConsoleCommand(line);
  if (const auto* error = std::get_if<ParseError>(&parsed)) {
    return isLabel(error->what, kMaxSentenceBytes) ? std::string() : "an error that cannot be shown";
  }
  return std::visit(Acceptable(), std::get<ConsoleCommand>(parsed)) ? std::string() : "a command with bad values";
}

// The bytes arrive in two parts, which must make no difference.
std::string streamFault(Bytes input, std::size_t cut) {
  const std::string text(input.begin(), input.end());
  LineBuffer whole(kMaxConsoleLineBytes);
  LineBuffer parts(kMaxConsoleLineBytes);
  whole.add(text);
  parts.add(text.substr(0, cut));
  std::optional<std::string> early = parts.next();
  parts.add(text.substr(std::min(cut, text.size())));
  for (;;) {
    const auto line = whole.next();
    const auto other = early ? std::exchange(early, std::nullopt) : parts.next();
    if (line != other) return "a line depends on how its bytes arrive";
    if (!line) return whole.tooLong() == parts.tooLong() ? std::string() : "the length depends on the parts";
    if (line->size() > kMaxConsoleLineBytes) return "a line is too long";
    if (std::string fault = lineFault(*line); !fault.empty()) return fault;
  }
}

bool hasOnlyLabels(std::string lines) {
  std::replace(lines.begin(), lines.end(), '\n', ' ');
  return isLabel(lines, lines.size());
}

// What a terminal might obey is replaced, and nothing else.
std::string replyFault(Bytes input) {
  const std::string text(input.begin(), input.end());
  const ConsoleReply reply{text.size() % 2 == 0, text};
  const bool plain = !text.starts_with('\n') && !text.ends_with('\n') && text.find('\r') == std::string::npos;
  if (!plain) return {};
  LineBuffer lines(encode(reply).size());
  lines.add(encode(reply));
  ConsoleReplyReader reader;
  while (const auto line = lines.next()) {
    const auto received = reader.add(*line);
    if (!received) continue;
    if (!hasOnlyLabels(received->text)) return "a reply has what a terminal might obey";
    return *received == reply || !hasOnlyLabels(text) ? std::string() : "a reply has changed";
  }
  return "a reply does not end";
}

// What arrives later does not change an answer.
std::string requestFault(Bytes input, std::size_t cut) {
  const std::string request(input.begin(), input.end());
  const auto early = answerTo(request.substr(0, cut), "/metrics");
  const auto late = answerTo(request, "/metrics");
  if (early && early != late) return "an answer has changed";
  const bool complete = request.find("\r\n\r\n") != std::string::npos || request.size() > kMaxHttpHeadBytes;
  return late.has_value() == complete ? std::string() : "a complete request has no answer, or an incomplete one has";
}

}  // namespace

std::string consoleFault(Bytes input) {
  ByteSource bytes(input);
  const std::size_t kind = bytes.below(3);
  const std::size_t cut = bytes.below(256);
  if (kind == 0) return streamFault(bytes.remaining(), cut);
  return kind == 1 ? replyFault(bytes.remaining()) : requestFault(bytes.remaining(), cut);
}

}  // namespace platon::fuzz
