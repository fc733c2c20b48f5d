#include "levels/drawing/typeface.h"

#include <span>
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

std::u32string codePointsOf(std::string_view utf8) {
  std::u32string points;
  while (!utf8.empty()) {
    const char32_t point = takeCodePoint(utf8);
    if (!isControlCharacter(point)) points.push_back(point);
  }
  return points;
}

Typeface::Typeface() : info_(std::make_unique<stbtt_fontinfo>()) {
  if (stbtt_InitFont(info_.get(), platonFontData, 0) == 0) throw std::runtime_error("the built-in font cannot be read");
  scale_ = stbtt_ScaleForPixelHeight(info_.get(), 1);
}

Typeface::~Typeface() = default;

std::vector<Typeface::OutlineStep> Typeface::outline(char32_t codePoint) const {
  stbtt_vertex* vertices = nullptr;
  const int count = stbtt_GetCodepointShape(info_.get(), static_cast<int>(codePoint), &vertices);
  std::vector<OutlineStep> steps;
  for (const stbtt_vertex& vertex : std::span(vertices, static_cast<std::size_t>(count))) {
    using Kind = OutlineStep::Kind;
    const Kind kind = vertex.type == STBTT_vmove   ? Kind::kMove
                      : vertex.type == STBTT_vline ? Kind::kLine
                                                   : Kind::kCurve;
    const glm::vec2 control = kind == Kind::kCurve ? scale_ * glm::vec2(vertex.cx, vertex.cy) : glm::vec2(0);
    steps.push_back({kind, scale_ * glm::vec2(vertex.x, vertex.y), control});
  }
  stbtt_FreeShape(info_.get(), vertices);
  return steps;
}

float Typeface::advance(char32_t codePoint) const {
  int units = 0;
  stbtt_GetCodepointHMetrics(info_.get(), static_cast<int>(codePoint), &units, nullptr);
  return static_cast<float>(units) * scale_;
}

float Typeface::width(std::string_view utf8) const {
  float sum = 0;
  for (const char32_t point : codePointsOf(utf8)) sum += advance(point);
  return sum;
}

}  // namespace platon
