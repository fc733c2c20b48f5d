#include "shared/game/level_text.h"

#include <algorithm>
#include <optional>
#include <string>

#include "platon/game/utf8.h"

namespace platon {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool isBlank(char byte) { return byte == ' ' || byte == '\t'; }

int columnOf(std::size_t index) { return static_cast<int>(index) + 1; }

bool isForbidden(char32_t codePoint) { return isControlCharacter(codePoint) && codePoint != '\t'; }

std::string describeControl(char32_t codePoint) {
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
    const auto character = decodeUtf8(content.substr(i));
    if (!character) return Fault{i, "invalid UTF-8: save the file as UTF-8"};
    if (isForbidden(character->codePoint)) return Fault{i, describeControl(character->codePoint)};
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
  for (std::size_t i = 0; i < tokens && !line.invalid;) {
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
    line.invalid = true;
  else
    line.comment = {};
}

}  // namespace platon
