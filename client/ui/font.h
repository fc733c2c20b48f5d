#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "levels/drawing/typeface.h"

namespace platon {

/// The typeface with glyphs that a graphics card can draw.
class Font : public Typeface {
 public:
  /// A glyph as a signed distance field, which can be drawn sharply at any size.
  struct Glyph {
    glm::vec2 low{0};   ///< lower left corner of the field, from the pen position on the baseline, at size 1
    glm::vec2 high{0};  ///< upper right corner
    int width = 0;      ///< samples; 0 for a blank
    int height = 0;     ///< samples
    std::vector<std::uint8_t> distances;  ///< rows from the top; kOnOutline on the outline, greater inside
  };
  static constexpr int kOnOutline = 128;

  Font();

  Glyph glyph(char32_t codePoint) const;
};

}  // namespace platon
