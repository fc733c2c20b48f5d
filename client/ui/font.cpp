#include "client/ui/font.h"

#include <cstddef>
#include <stdexcept>

#include <stb/stb_truetype.h>

#include "platon/game/utf8.h"

// Embeds the font file in the program.
__asm__(
    ".section .rodata\n"
    ".balign 16\n"
    ".global platonFontData\n"
    "platonFontData:\n"
    ".incbin \"" PLATON_FONT_FILE
    "\"\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const unsigned char platonFontData[];

namespace platon {
namespace {

constexpr float kSamplesPerLine = 36;  // resolution of the distance fields
constexpr int kPadding = 5;            // samples around the outline
constexpr float kSlope = 24;           // change of the distance value per sample

}  // namespace

std::u32string codePointsOf(std::string_view utf8) {
  std::u32string points;
  while (!utf8.empty()) {
    const char32_t point = takeCodePoint(utf8);
    if (!isControlCharacter(point)) points.push_back(point);
  }
  return points;
}

Font::Font() : info_(std::make_unique<stbtt_fontinfo>()) {
  if (stbtt_InitFont(info_.get(), platonFontData, 0) == 0) throw std::runtime_error("the built-in font cannot be read");
  scale_ = stbtt_ScaleForPixelHeight(info_.get(), 1);
}

Font::~Font() = default;

Font::Glyph Font::glyph(char32_t codePoint) const {
  Glyph glyph;
  int left = 0;
  int top = 0;
  unsigned char* field = stbtt_GetCodepointSDF(info_.get(), scale_ * kSamplesPerLine, static_cast<int>(codePoint),
                                               kPadding, kOnOutline, kSlope, &glyph.width, &glyph.height, &left, &top);
  if (field == nullptr) return Glyph();
  glyph.distances.assign(field, field + std::ptrdiff_t{1} * glyph.width * glyph.height);
  stbtt_FreeSDF(field, nullptr);
  glyph.low = glm::vec2(left, -(top + glyph.height)) / kSamplesPerLine;
  glyph.high = glm::vec2(left + glyph.width, -top) / kSamplesPerLine;
  return glyph;
}

float Font::advance(char32_t codePoint) const {
  int units = 0;
  stbtt_GetCodepointHMetrics(info_.get(), static_cast<int>(codePoint), &units, nullptr);
  return static_cast<float>(units) * scale_;
}

float Font::width(std::string_view utf8) const {
  float sum = 0;
  for (const char32_t point : codePointsOf(utf8)) sum += advance(point);
  return sum;
}

}  // namespace platon
