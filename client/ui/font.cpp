#include "client/ui/font.h"

#include <cstddef>

#include <stb/stb_truetype.h>

namespace platon {
namespace {

constexpr float kSamplesPerLine = 36;  // resolution of the distance fields
constexpr int kPadding = 5;            // samples around the outline
constexpr float kSlope = 24;           // change of the distance value per sample

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

}  // namespace platon
