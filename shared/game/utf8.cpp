#include "platon/game/utf8.h"

#include <cstdint>

namespace platon {
namespace {

constexpr char32_t kReplacementCharacter = 0xfffd;

// Bytes of the sequence that starts with `lead`; 0 for a byte that starts none. 0xc0, 0xc1 and 0xf5 … 0xff occur in no
// well-formed text.
std::size_t sequenceLength(std::uint8_t lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

bool isOverlong(char32_t codePoint, std::size_t length) {
  return (length == 3 && codePoint < 0x800) || (length == 4 && codePoint < 0x10000);
}

bool isSurrogate(char32_t codePoint) { return codePoint >= 0xd800 && codePoint < 0xe000; }

}  // namespace

std::optional<Utf8Character> decodeUtf8(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const auto lead = static_cast<std::uint8_t>(text[0]);
  const std::size_t length = sequenceLength(lead);
  if (length == 0 || length > text.size()) return std::nullopt;
  char32_t codePoint = length == 1 ? lead : lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    if ((next & 0xc0u) != 0x80u) return std::nullopt;
    codePoint = codePoint << 6 | (next & 0x3fu);
  }
  if (isOverlong(codePoint, length) || isSurrogate(codePoint) || codePoint > 0x10ffff) return std::nullopt;
  return Utf8Character{codePoint, length};
}

char32_t takeCodePoint(std::string_view& text) {
  const auto character = decodeUtf8(text);
  text.remove_prefix(character ? character->length : 1);
  return character ? character->codePoint : kReplacementCharacter;
}

bool isControlCharacter(char32_t codePoint) { return codePoint < 0x20 || (codePoint >= 0x7f && codePoint < 0xa0); }

}  // namespace platon
