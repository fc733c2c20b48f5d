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

/// The letter that combining characters would change, as a label is read from its beginning.
class Letter {
 public:
  /// Nothing to combine with.
  void end() { marks_.reset(); }
  /// A character that does not combine, with the marks that it is composed of.
  void begin(char32_t code) {
    marks_ = partsOf(code);
    std::erase_if(*marks_, [](char32_t part) { return !isCombining(part); });
  }
  /// Adds a combining character. False, without effect, if there is no letter, or the letter has it already or enough
  /// others.
  bool add(char32_t code) {
    if (!marks_) return false;
    CodePoints marks = *marks_;
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
  std::optional<CodePoints> marks_;  // nothing: no letter
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
  std::string visible;
  Letter letter;
  bool spaceBefore = false;
  while (!label.empty()) {
    const std::string_view rest = label;
    const char32_t code = takeCodePoint(label);
    if (isBlank(code)) {
      spaceBefore = !visible.empty();
      letter.end();
    }
    if (isBlank(code) || isInvisible(code)) continue;
    if (isCombining(code) && !letter.add(code)) continue;
    if (!isCombining(code)) letter.begin(code);
    if (spaceBefore) visible += ' ';
    visible += rest.substr(0, rest.size() - label.size());
    spaceBefore = false;
  }
  return visible;
}

// The order of marks is made canonical first, because case folding makes a letter of one.
std::string lookAlikeKey(std::string_view label) {
  const std::string ordered = mapped(visibleLabel(label), UTF8PROC_STABLE | UTF8PROC_DECOMPOSE);
  return mapped(ordered, UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_COMPAT | UTF8PROC_CASEFOLD);
}

}  // namespace platon
