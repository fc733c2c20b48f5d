#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

struct stbtt_fontinfo;

namespace platon {

/// The code points of a UTF-8 text without its control characters. A malformed byte becomes U+FFFD.
std::u32string codePointsOf(std::string_view utf8);

/// The one typeface of the game, DejaVu Sans Bold, which is part of the program. Sizes count from the baseline of one
/// line to that of the next; +y is up.
class Font {
 public:
  /// A glyph as a field of distances to its outline, which can be drawn sharply at any size.
  struct Glyph {
    glm::vec2 low{0};  ///< of the field, from the pen's place on the baseline, at size 1
    glm::vec2 high{0};
    int width = 0;  ///< of the field in samples; 0 for a blank
    int height = 0;
    std::vector<std::uint8_t> distances;  ///< rows from the top; kOnOutline on the outline, more inside
  };
  static constexpr int kOnOutline = 128;

  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  Glyph glyph(char32_t codePoint) const;
  /// How far the pen moves on, at size 1.
  float advance(char32_t codePoint) const;
  /// Of a whole line, at size 1.
  float width(std::string_view utf8) const;
  /// Height of a capital letter at size 1.
  static constexpr float kCapitalHeight = 0.626F;

 private:
  std::unique_ptr<stbtt_fontinfo> info_;
  float scale_ = 1;  // font units to size 1
};

}  // namespace platon
