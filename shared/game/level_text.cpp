#include "shared/game/level_text.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace platon {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool isBlank(char byte) { return byte == ' ' || byte == '\t'; }

int columnOf(std::size_t index) { return static_cast<int>(index) + 1; }

struct LeadByte {
  std::size_t length;  // of the whole sequence, 0 when no sequence begins so
  std::uint32_t bits;
  std::uint32_t smallest;  // code point that needs this length
};

LeadByte leadByte(std::uint8_t byte) {
  if (byte < 0x80) return {1, byte, 0};
  if (byte >= 0xc0 && byte < 0xe0) return {2, byte & 0x1fu, 0x80};
  if (byte >= 0xe0 && byte < 0xf0) return {3, byte & 0x0fu, 0x800};
  if (byte >= 0xf0 && byte < 0xf8) return {4, byte & 0x07u, 0x10000};
  return {0, 0, 0};
}

bool isControl(std::uint32_t codePoint) {
  return (codePoint < 0x20 && codePoint != '\t') || (codePoint >= 0x7f && codePoint < 0xa0);
}

bool isCodePoint(std::uint32_t value) { return value < 0x110000 && (value < 0xd800 || value >= 0xe000); }

// The code point at `index` and the number of its bytes; nothing when it is no UTF-8.
std::optional<LeadByte> decode(std::string_view text, std::size_t index) {
  LeadByte character = leadByte(static_cast<std::uint8_t>(text[index]));
  if (character.length == 0 || text.size() - index < character.length) return std::nullopt;
  for (std::size_t i = 1; i < character.length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[index + i]);
    if ((next & 0xc0) != 0x80) return std::nullopt;
    character.bits = character.bits << 6 | (next & 0x3fu);
  }
  if (character.bits < character.smallest || !isCodePoint(character.bits)) return std::nullopt;
  return character;
}

std::string describeControl(std::uint32_t codePoint) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex = {digits[codePoint >> 4], digits[codePoint & 15]};
  return "control character 0x" + hex + ": only tabs and line ends (LF or CR LF) are allowed";
}

struct Fault {
  std::size_t index;
  std::string message;
};

std::optional<Fault> firstFault(std::string_view content) {
  for (std::size_t i = 0; i < content.size();) {
    const auto character = decode(content, i);
    if (!character) return Fault{i, "the text is no valid UTF-8 here"};
    if (isControl(character->bits)) return Fault{i, describeControl(character->bits)};
    i += character->length;
  }
  return std::nullopt;
}

}  // namespace

LevelText::LevelText(std::string_view text, Diagnostics& diagnostics) : rest_(text), diagnostics_(&diagnostics) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::string_view LevelText::takeLine() {
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view content = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (content.ends_with('\r')) content.remove_suffix(1);
  return content;
}

bool LevelText::next(LevelLine& line) {
  if (rest_.empty()) return false;
  const std::string_view content = takeLine();
  line = LevelLine();
  line.number = ++number_;
  endOfLine_ = columnOf(content.size());
  const std::size_t tokens = std::min(content.find('#'), content.size());
  line.comment = content.substr(tokens);
  line.commentColumn = columnOf(tokens);
  checkBytes(content, tokens, line);
  for (std::size_t i = 0; i < tokens && !line.broken;) {
    if (isBlank(content[i])) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < tokens && !isBlank(content[i])) ++i;
    line.tokens.push_back({content.substr(first, i - first), columnOf(first)});
    line.end = columnOf(i);
  }
  return true;
}

void LevelText::checkBytes(std::string_view content, std::size_t tokens, LevelLine& line) {
  const auto fault = firstFault(content);
  if (!fault) return;
  diagnostics_->error({line.number, columnOf(fault->index)}, fault->message);
  if (fault->index < tokens)
    line.broken = true;
  else
    line.comment = {};
}

}  // namespace platon
