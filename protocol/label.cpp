#include "protocol/label.h"

#include "platon/game/utf8.h"

namespace platon {
namespace {

bool isShown(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  const bool lineBreak = within(0x2028, 0x2029);
  const bool direction = within(0x200e, 0x200f) || within(0x202a, 0x202e) || within(0x2066, 0x2069) || code == 0x61c;
  return !isControlCharacter(code) && !lineBreak && !direction;
}

}  // namespace

bool isLabel(std::string_view text, std::size_t maxBytes) {
  if (text.size() > maxBytes) return false;
  while (!text.empty()) {
    const auto character = decodeUtf8(text);
    if (!character || !isShown(character->codePoint)) return false;
    text.remove_prefix(character->length);
  }
  return true;
}

}  // namespace platon
