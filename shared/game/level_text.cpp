#include "platon/game/level_text.h"

#include <algorithm>
#include <utility>

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

// `comment`: index of the comment.
std::optional<LevelLine::Fault> firstFault(std::string_view content, std::size_t comment) {
  for (std::size_t i = 0; i < content.size();) {
    const auto character = decodeUtf8(content.substr(i));
    if (!character) return LevelLine::Fault{columnOf(i), i >= comment, "invalid UTF-8: save the file as UTF-8"};
    if (isForbidden(character->codePoint))
      return LevelLine::Fault{columnOf(i), i >= comment, describeControl(character->codePoint)};
    i += character->length;
  }
  return std::nullopt;
}

std::string_view withoutLineEnd(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

LevelLine splitLevelLine(std::string_view text) {
  LevelLine line;
  line.text = text;
  const std::string_view content = withoutLineEnd(text);
  const std::size_t comment = std::min(content.find('#'), content.size());
  line.comment = content.substr(comment);
  line.commentColumn = columnOf(comment);
  line.fault = firstFault(content, comment);
  for (std::size_t i = 0; i < comment;) {
    if (isBlank(content[i])) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < comment && !isBlank(content[i])) ++i;
    line.tokens.push_back({content.substr(first, i - first), columnOf(first)});
    line.end = columnOf(i);
  }
  return line;
}

bool LevelText::next(LevelLine& line) {
  if (rest_.empty()) return false;
  const std::string_view whole = rest_.substr(0, std::min(rest_.find('\n'), rest_.size() - 1) + 1);
  const bool isMarked = number_ == 0 && whole.starts_with(kByteOrderMark);
  const std::string_view text = whole.substr(isMarked ? kByteOrderMark.size() : 0);
  if (text.empty()) return false;
  line = splitLevelLine(text);
  line.text = whole;
  line.number = ++number_;
  endOfLine_ = columnOf(withoutLineEnd(text).size());
  rest_.remove_prefix(whole.size());
  if (line.tokens.empty()) return true;
  if (line.tokens[0].text == "%" && !line.isUnreadable()) {
    line.role = LevelLine::Role::kFaceMark;
    header_ = LevelLine::kHeaderLines;
    ++faces_;
  } else if (header_ < LevelLine::kHeaderLines) {
    line.role = LevelLine::Role::kHeader;
    ++header_;
  } else {
    line.role = LevelLine::Role::kSegment;
  }
  line.face = faces_ - 1;
  return true;
}

}  // namespace platon
