#include "protocol/label.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "platon/game/utf8.h"
#include "protocol/unicode_tables.h"

namespace platon {
namespace {

// Characters that nobody sees: those with the property Default_Ignorable_Code_Point, annotation marks, and code points
// that are no characters or private.
constexpr CodeRange kInvisible[] = {
    {0xad, 0xad},       {0x34f, 0x34f},     {0x61c, 0x61c},     {0x115f, 0x1160},    {0x17b4, 0x17b5},
    {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},   {0x2060, 0x206f},    {0x3164, 0x3164},
    {0xe000, 0xf8ff},   {0xfdd0, 0xfdef},   {0xfe00, 0xfe0f},   {0xfeff, 0xfeff},    {0xffa0, 0xffa0},
    {0xfff0, 0xfffc},   {0xfffe, 0xffff},   {0x13430, 0x1345f}, {0x1bca0, 0x1bca3},  {0x1d159, 0x1d159},
    {0x1d173, 0x1d17a}, {0x1fffe, 0x1ffff}, {0x2fffe, 0x2ffff}, {0x3fffe, 0x10ffff},
};
// Spaces, and the braille pattern without dots.
constexpr CodeRange kBlank[] = {{0x20, 0x20},     {0xa0, 0xa0},     {0x1680, 0x1680}, {0x2000, 0x200a},
                                {0x202f, 0x202f}, {0x205f, 0x205f}, {0x2800, 0x2800}, {0x3000, 0x3000}};

// The range of a table in order that contains the code point; null if there is none.
template <class Range>
const Range* rangeOf(std::span<const Range> table, char32_t code) {
  const auto found = std::lower_bound(table.begin(), table.end(), code,
                                      [](const Range& range, char32_t point) { return range.last < point; });
  return found != table.end() && found->first <= code ? &*found : nullptr;
}

bool isIn(std::span<const CodeRange> table, char32_t code) { return rangeOf(table, code) != nullptr; }

bool isShown(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  const bool lineBreak = within(0x2028, 0x2029);
  const bool direction = within(0x200e, 0x200f) || within(0x202a, 0x202e) || within(0x2066, 0x2069) || code == 0x61c;
  return !isControlCharacter(code) && !lineBreak && !direction;
}

char32_t folded(char32_t code) {
  const CaseRange* range = rangeOf(std::span<const CaseRange>(kCaseFolding), code);
  if (!range || (code - range->first) % range->step != 0) return code;
  return static_cast<char32_t>(static_cast<std::int32_t>(code) + range->distance);
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
  bool spaceBefore = false;
  bool combines = false;  // whether a character precedes that a combining one can change
  while (!label.empty()) {
    const std::string_view rest = label;
    const char32_t code = takeCodePoint(label);
    if (isIn(kBlank, code)) {
      spaceBefore = !visible.empty();
      combines = false;
    }
    if (isIn(kBlank, code) || isIn(kInvisible, code) || isControlCharacter(code)) continue;
    if (!combines && isIn(kCombiningCharacters, code)) continue;
    if (spaceBefore) visible += ' ';
    visible += rest.substr(0, rest.size() - label.size());
    spaceBefore = false;
    combines = true;
  }
  return visible;
}

std::u32string lookAlikeKey(std::string_view label) {
  const std::string visible = visibleLabel(label);
  std::u32string key;
  for (std::string_view rest = visible; !rest.empty();) key += folded(takeCodePoint(rest));
  return key;
}

}  // namespace platon
