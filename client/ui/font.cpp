#include "client/ui/font.h"

#include <algorithm>
#include <cstddef>

#include <stb/stb_truetype.h>

#include "platon/game/utf8.h"

namespace platon {
namespace {

constexpr float kSamplesPerLine = 36;  // resolution of the distance fields
constexpr int kPadding = 5;            // samples around the outline
constexpr float kSlope = 24;           // change of the distance value per sample

// Removes the text up to the next space, and that space.
std::string_view takeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(word.size() + 1, text.size()));
  return word;
}

// Removes as many code points as are at most `width` wide together, but at least one.
std::string_view takePart(std::string_view& word, const Font& font, float width) {
  std::string_view rest = word;
  takeCodePoint(rest);
  while (!rest.empty()) {
    std::string_view next = rest;
    takeCodePoint(next);
    if (font.width(word.substr(0, word.size() - next.size())) > width) break;
    rest = next;
  }
  const std::string_view part = word.substr(0, word.size() - rest.size());
  word = rest;
  return part;
}

}  // namespace

Font::Font() = default;

Font::Glyph Font::glyph(char32_t codePoint) const {
  Glyph glyph;
  int left = 0;
  int top = 0;
  const Source from = source(codePoint);
  unsigned char* field = stbtt_GetGlyphSDF(from.file, from.scale * kSamplesPerLine, from.glyph, kPadding, kOnOutline,
                                           kSlope, &glyph.width, &glyph.height, &left, &top);
  if (field == nullptr) return Glyph();
  glyph.distances.assign(field, field + std::ptrdiff_t{1} * glyph.width * glyph.height);
  stbtt_FreeSDF(field, nullptr);
  const glm::vec2 shift(from.shift, 0);
  glyph.low = glm::vec2(left, -(top + glyph.height)) / kSamplesPerLine + shift;
  glyph.high = glm::vec2(left + glyph.width, -top) / kSamplesPerLine + shift;
  return glyph;
}

std::string fittedText(std::string_view text, const Font& font, float width) {
  if (font.width(text) <= width) return std::string(text);
  std::string fitted;
  std::string_view rest = text;
  while (!rest.empty()) {
    takeCodePoint(rest);
    std::string longer = std::string(text.substr(0, text.size() - rest.size())) + "…";
    if (font.width(longer) > width) break;
    fitted = std::move(longer);
  }
  return fitted;
}

std::vector<std::string> wrapText(std::string_view utf8, const Font& font, float width) {
  std::vector<std::string> lines;
  while (!utf8.empty()) {
    std::string_view word = takeWord(utf8);
    if (word.empty()) continue;
    if (!lines.empty() && font.width(lines.back() + ' ' + std::string(word)) <= width) {
      lines.back().append(" ").append(word);
      continue;
    }
    while (!word.empty()) lines.emplace_back(takePart(word, font, width));
  }
  return lines;
}

}  // namespace platon
