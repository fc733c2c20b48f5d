#include "client/gl/glyph_atlas.h"

#include <algorithm>

namespace platon {
namespace {

constexpr int kSize = 1536;

}  // namespace

GlyphAtlas::GlyphAtlas(const Font& font) : font_(&font) {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSize, kSize, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

const GlyphAtlas::Entry& GlyphAtlas::entry(char32_t codePoint) {
  const auto known = entries_.find(codePoint);
  if (known != entries_.end()) return known->second;
  return entries_.emplace(codePoint, made(codePoint)).first->second;
}

bool GlyphAtlas::place(int width, int height, glm::ivec2& corner) {
  if (pen_.x + width > kSize) {
    pen_ = {0, pen_.y + rowHeight_};
    rowHeight_ = 0;
  }
  if (width > kSize || pen_.y + height > kSize) return false;
  corner = pen_;
  pen_.x += width;
  rowHeight_ = std::max(rowHeight_, height);
  return true;
}

GlyphAtlas::Entry GlyphAtlas::made(char32_t codePoint) {
  Entry entry;
  entry.advance = font_->advance(codePoint);
  const Font::Glyph glyph = font_->glyph(codePoint);
  glm::ivec2 corner(0);
  if (glyph.width == 0 || !place(glyph.width, glyph.height, corner)) return entry;
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, corner.x, corner.y, glyph.width, glyph.height, GL_RED, GL_UNSIGNED_BYTE,
                  glyph.distances.data());
  const glm::vec2 size(glyph.width, glyph.height);
  entry.low = glyph.low;
  entry.high = glyph.high;
  entry.lowTexel = (glm::vec2(corner) + glm::vec2(0, size.y)) / float{kSize};
  entry.highTexel = (glm::vec2(corner) + glm::vec2(size.x, 0)) / float{kSize};
  entry.blank = false;
  return entry;
}

}  // namespace platon
