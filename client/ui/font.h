#pragma once

#include <cstdint>
#include <string>
#include <string_view>
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

/// The text if it is at most `width` wide at size 1, or else its longest beginning that is with an ellipsis.
std::string fittedText(std::string_view text, const Font& font, float width);

/// Breaks a text at its spaces into lines that are at most `width` wide, at size 1. A word that is wider is broken
/// between code points; a line has at least one of them.
std::vector<std::string> wrapText(std::string_view utf8, const Font& font, float width);

}  // namespace platon
