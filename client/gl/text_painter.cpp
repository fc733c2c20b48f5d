#include "client/gl/text_painter.h"

#include <array>
#include <cstddef>

namespace platon {

TextPainter::TextPainter(const Font& font) : atlas_(font), program_("text") {
  stream_.attribute(0, 2, offsetof(Vertex, place));
  stream_.attribute(1, 2, offsetof(Vertex, texel));
  stream_.attribute(2, 4, offsetof(Vertex, colour));
}

void TextPainter::add(std::string_view utf8, glm::vec2 origin, glm::vec2 along, glm::vec2 up, glm::vec4 colour) {
  for (const char32_t point : codePointsOf(utf8)) {
    glyphs_.push_back({point, origin, along, up, colour});
    origin += along * atlas_.font().advance(point);
  }
}

void TextPainter::addCentred(std::string_view utf8, glm::vec2 middle, glm::vec2 up, glm::vec4 colour) {
  const glm::vec2 along(up.y, -up.x);
  const glm::vec2 half = atlas_.font().width(utf8) / 2 * along + Font::kCapitalHeight / 2 * up;
  add(utf8, middle - half, along, up, colour);
}

void TextPainter::flush(const glm::mat4& toClip, float halo) {
  if (glyphs_.empty()) return;
  program_.use();
  program_.set("toClip", toClip);
  program_.set("atlas", 0);
  program_.set("halo", halo);
  for (const PlacedGlyph& glyph : glyphs_) {
    const GlyphAtlas::Entry* entry = atlas_.find(glyph.codePoint);
    if (entry == nullptr) {
      // The texture is full: draw the vertices that refer to it, then refill it.
      drawVertices();
      atlas_.clear();
      entry = atlas_.find(glyph.codePoint);
    }
    if (!entry->blank) addVertices(glyph, *entry);
  }
  drawVertices();
  glyphs_.clear();
}

void TextPainter::addVertices(const PlacedGlyph& glyph, const GlyphAtlas::Entry& entry) {
  const auto corner = [&](bool right, bool top) {
    const glm::vec2 at(right ? entry.high.x : entry.low.x, top ? entry.high.y : entry.low.y);
    const glm::vec2 texel(right ? entry.highTexel.x : entry.lowTexel.x, top ? entry.highTexel.y : entry.lowTexel.y);
    return Vertex{glyph.origin + at.x * glyph.along + at.y * glyph.up, texel, glyph.colour};
  };
  for (const auto& [right, top] :
       {std::array{false, false}, {true, false}, {true, true}, {false, false}, {true, true}, {false, true}}) {
    vertices_.push_back(corner(right, top));
  }
}

void TextPainter::drawVertices() {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, atlas_.texture());
  stream_.drawTriangles(vertices_);
  vertices_.clear();
}

}  // namespace platon
