#include "protocol/label.h"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <vector>

#include "platon/game/utf8.h"

namespace platon {
namespace {

using CodePoints = std::u32string;

const utf8proc_property_t& propertyOf(char32_t code) {
  return *utf8proc_get_property(static_cast<utf8proc_int32_t>(code));
}

// Spaces, and the braille pattern without dots.
bool isBlank(char32_t code) { return propertyOf(code).category == UTF8PROC_CATEGORY_ZS || code == 0x2800; }

bool isCombining(char32_t code) {
  const auto category = propertyOf(code).category;
  return category == UTF8PROC_CATEGORY_MN || category == UTF8PROC_CATEGORY_MC || category == UTF8PROC_CATEGORY_ME;
}

// Combining characters of class 0 that do not enclose are vowels and the like, which a letter may have more of.
bool isAccent(char32_t code) {
  return propertyOf(code).combining_class != 0 || propertyOf(code).category == UTF8PROC_CATEGORY_ME;
}

// Annotation marks, and controls that arrange hieroglyphs: Unicode has no property that tells that nobody sees them.
bool isFormatControl(char32_t code) {
  return (code >= 0xfff9 && code <= 0xfffc) || (code >= 0x13430 && code <= 0x1343f);
}

bool isInvisible(char32_t code) {
  switch (propertyOf(code).category) {
    case UTF8PROC_CATEGORY_CN:  // assigned to no character
    case UTF8PROC_CATEGORY_CC:
    case UTF8PROC_CATEGORY_CS:
    case UTF8PROC_CATEGORY_CO:  // private
    case UTF8PROC_CATEGORY_ZL:
    case UTF8PROC_CATEGORY_ZP:
      return true;
    default:
      return propertyOf(code).ignorable || isFormatControl(code);
  }
}

bool isShown(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  const bool lineBreak = within(0x2028, 0x2029);
  const bool direction = within(0x200e, 0x200f) || within(0x202a, 0x202e) || within(0x2066, 0x2069) || code == 0x61c;
  return !isControlCharacter(code) && !lineBreak && !direction;
}

// The canonical decomposition of a character.
CodePoints partsOf(char32_t code) {
  std::array<utf8proc_int32_t, 8> parts{};  // Unicode has none of more than 4
  int boundary = 0;
  const auto count = utf8proc_decompose_char(static_cast<utf8proc_int32_t>(code), parts.data(), parts.size(),
                                             UTF8PROC_DECOMPOSE, &boundary);
  return {parts.begin(), parts.begin() + std::clamp<utf8proc_ssize_t>(count, 0, parts.size())};
}

/// The marks of a letter, as it is read from its beginning.
class Marks {
 public:
  /// Those of which the first character is composed.
  explicit Marks(char32_t first) : marks_(partsOf(first)) {
    std::erase_if(marks_, [](char32_t part) { return !isCombining(part); });
  }
  /// Adds a combining character. False, without effect, if the letter has it already or enough others.
  bool add(char32_t code) {
    CodePoints marks = marks_;
    for (const char32_t mark : partsOf(code)) {
      if (marks.find(mark) != CodePoints::npos) return false;
      marks += mark;
    }
    const auto accents = static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(), isAccent));
    if (accents > kMaxAccents || marks.size() - accents > kMaxVowelSigns) return false;
    marks_ = std::move(marks);
    return true;
  }

 private:
  CodePoints marks_;
};

// Text that is mapped by utf8proc; unchanged if it is not UTF-8.
std::string mapped(std::string_view text, int options) {
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
  const auto size = static_cast<utf8proc_ssize_t>(text.size());
  const auto option = static_cast<utf8proc_option_t>(options);
  const utf8proc_ssize_t count = utf8proc_decompose(bytes, size, nullptr, 0, option);
  if (count < 0) return std::string(text);
  std::vector<utf8proc_int32_t> points(static_cast<std::size_t>(count) + 1);  // and a zero that ends the text
  utf8proc_decompose(bytes, size, points.data(), count, option);
  const utf8proc_ssize_t length = utf8proc_reencode(points.data(), count, option);
  return {reinterpret_cast<const char*>(points.data()), static_cast<std::size_t>(length)};
}

// The label without what nobody sees, combining characters without a letter included.
std::string withoutInvisible(std::string_view label) {
  std::string visible;
  bool isAfterBlank = true;
  while (!label.empty()) {
    const std::string_view rest = label;
    const char32_t code = takeCodePoint(label);
    isAfterBlank = isAfterBlank || isBlank(code);
    if (isBlank(code) || isInvisible(code) || (isAfterBlank && isCombining(code))) continue;
    if (isAfterBlank && !visible.empty()) visible += ' ';
    visible += rest.substr(0, rest.size() - label.size());
    isAfterBlank = false;
  }
  return visible;
}

// Takes the first character and those that combine with it.
std::string_view takeLetter(std::string_view& text) {
  const std::string_view all = text;
  takeCodePoint(text);
  for (std::string_view rest = text; !rest.empty() && isCombining(takeCodePoint(rest));) text = rest;
  return all.substr(0, all.size() - text.size());
}

// The letter without the combining characters that are too many.
std::string withFewMarks(std::string_view letter) {
  const std::string_view all = letter;
  Marks marks(takeCodePoint(letter));
  std::string few(all.substr(0, all.size() - letter.size()));
  while (!letter.empty()) {
    const std::string_view rest = letter;
    if (marks.add(takeCodePoint(letter))) few += rest.substr(0, rest.size() - letter.size());
  }
  return few;
}

// Marks are limited in NFC, so that neither their order nor the form of the letter decides which of them stay. Where
// this needs more room than the letter has, as for some composed letters of Hebrew, the marks stay that come first.
std::string visibleLetter(std::string_view letter) {
  const std::string composed = mapped(letter, UTF8PROC_STABLE | UTF8PROC_COMPOSE);
  const std::string limited = withFewMarks(composed);
  if (limited == composed) return std::string(letter);
  return limited.size() <= letter.size() ? limited : withFewMarks(letter);
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

std::string visibleLabel(std::string_view label) {
  const std::string seen = withoutInvisible(label);
  std::string visible;
  for (std::string_view rest = seen; !rest.empty();) visible += visibleLetter(takeLetter(rest));
  return visible;
}

// The order of marks is made canonical first, because case folding makes a letter of one.
std::string lookAlikeKey(std::string_view label) {
  const std::string ordered = mapped(visibleLabel(label), UTF8PROC_STABLE | UTF8PROC_DECOMPOSE);
  return mapped(ordered, UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_COMPAT | UTF8PROC_CASEFOLD);
}

}  // namespace platon
