#pragma once

#include <unordered_map>

#include <glm/vec2.hpp>

#include "client/gl/gl_handle.h"
#include "client/ui/font.h"

namespace platon {

/// The glyphs used so far, in one texture. One that no longer fits stays blank.
class GlyphAtlas {
 public:
  struct Entry {
    glm::vec2 low{0};  ///< as in Font::Glyph
    glm::vec2 high{0};
    glm::vec2 lowTexel{0};  ///< where `low` is in the texture, 0 … 1
    glm::vec2 highTexel{0};
    float advance = 0;
    bool blank = true;
  };

  explicit GlyphAtlas(const Font& font);

  const Entry& entry(char32_t codePoint);
  const Font& font() const { return *font_; }
  GLuint texture() const { return texture_.name(); }

 private:
  bool place(int width, int height, glm::ivec2& corner);
  Entry made(char32_t codePoint);

  const Font* font_;
  GlTexture texture_;
  std::unordered_map<char32_t, Entry> entries_;
  glm::ivec2 pen_{0};  // where the next glyph goes: rows of the texture are filled from the left
  int rowHeight_ = 0;
};

}  // namespace platon
