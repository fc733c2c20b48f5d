#pragma once

#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/gl/glyph_atlas.h"
#include "client/gl/shader_program.h"
#include "client/gl/vertex_stream.h"

namespace platon {

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
