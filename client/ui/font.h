#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

struct stbtt_fontinfo;

namespace platon {

/// Decodes UTF-8. Each invalid byte becomes U+FFFD; control characters are omitted.
std::u32string codePointsOf(std::string_view utf8);

/// The typeface of the game, DejaVu Sans Bold, compiled into the program. The size of text is the distance between the
/// baselines of two lines; +y is up.
class Font {
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
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  Glyph glyph(char32_t codePoint) const;
  /// Horizontal distance to the next glyph, at size 1.
  float advance(char32_t codePoint) const;
  /// Width of a line of text, at size 1.
  float width(std::string_view utf8) const;
  /// Height of a capital letter at size 1.
  static constexpr float kCapitalHeight = 0.626F;

 private:
  std::unique_ptr<stbtt_fontinfo> info_;
  float scale_ = 1;  // font units to size 1
};

}  // namespace platon
