#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace platon {

/// One character of a UTF-8 text.
struct Utf8Character {
  char32_t codePoint = 0;
  std::size_t length = 0;  ///< bytes, 1 … 4
};

/// Decodes the first character of `text` (RFC 3629). Nothing when `text` is empty or does not begin with a well-formed
/// sequence: a stray continuation byte, a truncated sequence, an overlong form, a surrogate, or a value above U+10FFFF.
std::optional<Utf8Character> decodeUtf8(std::string_view text);

/// Removes the first character from `text`, which is not empty, and returns its code point. Where no well-formed
/// sequence begins, removes one byte and returns U+FFFD.
char32_t takeCodePoint(std::string_view& text);

/// True for the control characters U+0000 … U+001F (tab and line ends included) and U+007F … U+009F.
bool isControlCharacter(char32_t codePoint);

}  // namespace platon
