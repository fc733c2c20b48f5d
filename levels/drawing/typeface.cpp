#include "levels/drawing/typeface.h"

#include <span>
#include <stdexcept>

#include <stb/stb_truetype.h>

#include "platon/game/utf8.h"

// Embeds the font files in the program.
__asm__(
    ".section .rodata\n"
    ".balign 16\n"
    ".global platonFontData\n"
    "platonFontData:\n"
    ".incbin \"" PLATON_FIRST_FONT_FILE
    "\"\n"
    ".byte 0\n"
    ".balign 16\n"
    ".global platonFallbackFontData\n"
    "platonFallbackFontData:\n"
    ".incbin \"" PLATON_FALLBACK_FONT_FILE
    "\"\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const unsigned char platonFontData[];
extern "C" const unsigned char platonFallbackFontData[];

namespace platon {

std::u32string codePointsOf(std::string_view utf8) {
  std::u32string points;
  while (!utf8.empty()) {
    const char32_t point = takeCodePoint(utf8);
    if (!isControlCharacter(point)) points.push_back(point);
  }
  return points;
}

Typeface::Typeface() {
  const std::array<const unsigned char*, 2> data{platonFontData, platonFallbackFontData};
  for (std::size_t i = 0; i < files_.size(); ++i) {
    files_[i] = std::make_unique<stbtt_fontinfo>();
    if (stbtt_InitFont(files_[i].get(), data[i], 0) == 0) throw std::runtime_error("a built-in font cannot be read");
    int height = 0;
    stbtt_GetCodepointBox(files_[i].get(), 'H', nullptr, nullptr, nullptr, &height);
    scales_[i] = kCapitalHeight / static_cast<float>(height);
  }
  digitAdvance_ = source(U'0').advance;
}

Typeface::~Typeface() = default;

Typeface::Source Typeface::source(char32_t codePoint) const {
  Source source;
  for (std::size_t i = 0; i < files_.size() && source.glyph == 0; ++i) {
    source.file = files_[i].get();
    source.scale = scales_[i];
    source.glyph = stbtt_FindGlyphIndex(source.file, static_cast<int>(codePoint));
  }
  int units = 0;
  stbtt_GetGlyphHMetrics(source.file, source.glyph, &units, nullptr);
  source.advance = static_cast<float>(units) * source.scale;
  const bool isDigit = codePoint >= U'0' && codePoint <= U'9';
  if (isDigit && digitAdvance_ > 0) {
    source.shift = (digitAdvance_ - source.advance) / 2;
    source.advance = digitAdvance_;
  }
  return source;
}

std::vector<Typeface::OutlineStep> Typeface::outline(char32_t codePoint) const {
  const Source from = source(codePoint);
  stbtt_vertex* vertices = nullptr;
  const int count = stbtt_GetGlyphShape(from.file, from.glyph, &vertices);
  const glm::vec2 shift(from.shift, 0);
  std::vector<OutlineStep> steps;
  for (const stbtt_vertex& vertex : std::span(vertices, static_cast<std::size_t>(count))) {
    using Kind = OutlineStep::Kind;
    const Kind kind = vertex.type == STBTT_vmove   ? Kind::kMove
                      : vertex.type == STBTT_vline ? Kind::kLine
                                                   : Kind::kCurve;
    const bool isCurve = kind == Kind::kCurve;
    const glm::vec2 control = isCurve ? from.scale * glm::vec2(vertex.cx, vertex.cy) + shift : glm::vec2(0);
    steps.push_back({kind, from.scale * glm::vec2(vertex.x, vertex.y) + shift, control});
  }
  stbtt_FreeShape(from.file, vertices);
  return steps;
}

float Typeface::advance(char32_t codePoint) const { return source(codePoint).advance; }

float Typeface::width(std::string_view utf8) const {
  float sum = 0;
  for (const char32_t point : codePointsOf(utf8)) sum += advance(point);
  return sum;
}

}  // namespace platon
