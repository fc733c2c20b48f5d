#include "server/admin/console_reply.h"

#include <algorithm>
#include <utility>

#include "platon/game/utf8.h"
#include "protocol/label.h"

namespace platon {
namespace {

// The text with '?' for what a terminal might obey, such as a control character, and for bytes that are no UTF-8.
std::string shownOnTerminal(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const auto character = decodeUtf8(text);
    const std::string_view bytes = text.substr(0, character ? character->length : 1);
    shown += isLabel(bytes, bytes.size()) ? bytes : "?";
    text.remove_prefix(bytes.size());
  }
  return shown;
}

}  // namespace

std::string encode(const ConsoleReply& reply) {
  std::string encoded;
  for (std::string_view left = reply.text; !left.empty();) {
    const std::size_t end = std::min(left.find('\n'), left.size());
    encoded.append(" ").append(left.substr(0, end)).append("\n");
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return encoded + (reply.ok ? "ok\n" : "failed\n");
}

std::optional<ConsoleReply> ConsoleReplyReader::add(std::string_view line) {
  if (line.starts_with(' ')) {
    if (!reply_.text.empty()) reply_.text += '\n';
    reply_.text += shownOnTerminal(line.substr(1));
    return std::nullopt;
  }
  reply_.ok = line == "ok";
  return std::exchange(reply_, {});
}

}  // namespace platon
