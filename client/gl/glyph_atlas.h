#pragma once

#include <unordered_map>

#include <glm/vec2.hpp>

#include "client/gl/gl_handle.h"
#include "client/ui/font.h"

namespace platon {

/// Cache of rasterised glyphs in one texture, which is filled in rows from the left. Each has a border, which is
/// blended into its outermost pixels: beyond it lie other glyphs, or what the driver has left there.
class GlyphAtlas {
 public:
  /// A side of the texture in texels: enough for the visible names of 64 players without a glyph in common.
  static constexpr int kSize = 2048;

  struct Entry {
    glm::vec2 low{0};       ///< as in Font::Glyph
    glm::vec2 high{0};      ///< as in Font::Glyph
    glm::vec2 lowTexel{0};  ///< texture coordinates of `low`, 0 … 1
    glm::vec2 highTexel{0};
    bool blank = true;
  };

  /// `font` must outlive the atlas.
  explicit GlyphAtlas(const Font& font);

  /// Returns the entry of a glyph and adds it if needed; null if the texture is full. Valid until `clear`.
  const Entry* find(char32_t codePoint);
  /// Removes all glyphs.
  void clear();

  const Font& font() const { return *font_; }
  GLuint texture() const { return texture_.name(); }

 private:
  bool allocate(int width, int height, glm::ivec2& corner);
  Entry upload(const Font::Glyph& glyph, glm::ivec2 corner) const;

  const Font* font_;
  GlTexture texture_;
  std::unordered_map<char32_t, Entry> entries_;
  glm::ivec2 pen_{0};  // lower left corner of the next glyph's border
  int rowHeight_ = 0;
};

}  // namespace platon
