#include "protocol/label.h"

#include <cstdint>
#include <optional>

namespace platon {
namespace {

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

/// Bytes of the character that starts with `lead`; 0 when none does.
std::size_t lengthOf(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

/// Takes one character off the front; nothing when it is not well-formed UTF-8.
std::optional<std::uint32_t> takeCharacter(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lengthOf(lead);
  if (length == 0 || length > text.size()) return std::nullopt;
  std::uint32_t code = length == 1 ? lead : lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!isContinuation(text[i])) return std::nullopt;
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu);
  }
  text.remove_prefix(length);
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (overlong || surrogate || code > 0x10ffff) return std::nullopt;
  return code;
}

bool isShown(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) { return code >= first && code <= last; };
  const bool control = code < 0x20 || within(0x7f, 0x9f);
  const bool lineBreak = within(0x2028, 0x2029);
  const bool direction = within(0x200e, 0x200f) || within(0x202a, 0x202e) || within(0x2066, 0x2069) || code == 0x61c;
  return !control && !lineBreak && !direction;
}

}  // namespace

bool isLabel(std::string_view text, std::size_t maxBytes) {
  if (text.size() > maxBytes) return false;
  while (!text.empty()) {
    const auto code = takeCharacter(text);
    if (!code || !isShown(*code)) return false;
  }
  return true;
}

}  // namespace platon
