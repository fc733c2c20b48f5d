#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// What the server answers to a command of the console.
struct ConsoleReply {
  bool ok = true;
  std::string text;  ///< lines, perhaps none; each but the last ends with a line feed, and the first is not empty

  friend bool operator==(const ConsoleReply&, const ConsoleReply&) = default;
};

/// The reply as it is sent: each line of the text after a space, then a line `ok` or `failed`.
std::string encode(const ConsoleReply& reply);

/// Puts replies together from the lines that arrive. Whoever has sent them, the texts can be printed on a terminal: '?'
/// takes the place of control characters, marks that change the direction of writing, and bytes that are no UTF-8.
class ConsoleReplyReader {
 public:
  /// Adds a line, without its line feed. Returns the reply with the line that completes it.
  std::optional<ConsoleReply> add(std::string_view line);

 private:
  ConsoleReply reply_;
};

}  // namespace platon
