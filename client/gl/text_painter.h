#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
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

/// Draws lines of text in a plane: on the screen, on a face, on a ball.
class TextPainter {
 public:
  explicit TextPainter(const Font& font);

  /// Adds a line. `origin` is the left end of its baseline; `along` and `up` are the axes of the letters, and their
  /// length is the size of the text.
  void add(std::string_view utf8, glm::vec2 origin, glm::vec2 along, glm::vec2 up, glm::vec4 colour);
  /// Adds a line, upright where +y is up, with the middle of its capitals at `middle`.
  void addCentred(std::string_view utf8, glm::vec2 middle, float size, glm::vec4 colour) {
    addCentred(utf8, middle, glm::vec2(0, size), colour);
  }
  /// The same, upright in the direction of `up`, whose length is the size of the text.
  void addCentred(std::string_view utf8, glm::vec2 middle, glm::vec2 up, glm::vec4 colour);
  /// Draws and removes all lines. `halo` is the opacity of the dark outline around the letters.
  void flush(const glm::mat4& toClip, float halo);

 private:
  struct PlacedGlyph {
    char32_t codePoint;
    glm::vec2 origin;
    glm::vec2 along;
    glm::vec2 up;
    glm::vec4 colour;
  };
  struct Vertex {
    glm::vec2 place;
    glm::vec2 texel;
    glm::vec4 colour;
  };

  void addVertices(const PlacedGlyph& glyph, const GlyphAtlas::Entry& entry);
  void drawVertices();

  GlyphAtlas atlas_;
  ShaderProgram program_;
  VertexStream<Vertex> stream_;
  std::vector<PlacedGlyph> glyphs_;  // added since the last flush
  std::vector<Vertex> vertices_;     // of glyphs_ that are in the atlas
};

}  // namespace platon
