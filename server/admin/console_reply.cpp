#include "server/admin/console_reply.h"

#include <algorithm>
#include <utility>

namespace platon {

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
    reply_.text += line.substr(1);
    return std::nullopt;
  }
  reply_.ok = line == "ok";
  return std::exchange(reply_, {});
}

}  // namespace platon
