#include "client/gl/text_painter.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace platon {
namespace {

constexpr int kBorder = 1;

glm::ivec2 sizeWithBorder(const Font::Glyph& glyph) { return glm::ivec2(glyph.width, glyph.height) + 2 * kBorder; }

// The distances of a glyph within a border of the smallest one.
std::vector<std::uint8_t> withBorder(const Font::Glyph& glyph) {
  const glm::ivec2 size = sizeWithBorder(glyph);
  std::vector<std::uint8_t> framed(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int row = 0; row < glyph.height; ++row) {
    const auto from = glyph.distances.begin() + std::ptrdiff_t{row} * glyph.width;
    std::copy_n(from, glyph.width, framed.begin() + std::ptrdiff_t{row + kBorder} * size.x + kBorder);
  }
  return framed;
}

}  // namespace

GlyphAtlas::GlyphAtlas(const Font& font) : font_(&font) {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSize, kSize, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

const GlyphAtlas::Entry* GlyphAtlas::find(char32_t codePoint) {
  const auto known = entries_.find(codePoint);
  if (known != entries_.end()) return &known->second;
  const Font::Glyph glyph = font_->glyph(codePoint);
  glm::ivec2 corner(0);
  Entry entry;
  // A glyph larger than the texture never fits; it stays blank.
  const glm::ivec2 size = sizeWithBorder(glyph);
  const bool drawable = glyph.width > 0 && size.x <= kSize && size.y <= kSize;
  if (drawable) {
    if (!allocate(size.x, size.y, corner)) return nullptr;
    entry = upload(glyph, corner);
  }
  return &entries_.emplace(codePoint, entry).first->second;
}

void GlyphAtlas::clear() {
  entries_.clear();
  pen_ = {0, 0};
  rowHeight_ = 0;
}

bool GlyphAtlas::allocate(int width, int height, glm::ivec2& corner) {
  const bool newRow = pen_.x + width > kSize;
  const glm::ivec2 place = newRow ? glm::ivec2(0, pen_.y + rowHeight_) : pen_;
  if (place.y + height > kSize) return false;
  corner = place;
  pen_ = {place.x + width, place.y};
  rowHeight_ = newRow ? height : std::max(rowHeight_, height);
  return true;
}

GlyphAtlas::Entry GlyphAtlas::upload(const Font::Glyph& glyph, glm::ivec2 corner) const {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const glm::ivec2 size = sizeWithBorder(glyph);
  glTexSubImage2D(GL_TEXTURE_2D, 0, corner.x, corner.y, size.x, size.y, GL_RED, GL_UNSIGNED_BYTE,
                  withBorder(glyph).data());
  const glm::ivec2 inner = corner + kBorder;
  Entry entry;
  entry.low = glyph.low;
  entry.high = glyph.high;
  // The rows of a glyph start at its top, those of a texture at its bottom.
  entry.lowTexel = glm::vec2(inner + glm::ivec2(0, glyph.height)) / float{kSize};
  entry.highTexel = glm::vec2(inner + glm::ivec2(glyph.width, 0)) / float{kSize};
  entry.blank = false;
  return entry;
}

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
