#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

struct stbtt_fontinfo;

namespace platon {

/// Decodes UTF-8. Each invalid byte becomes U+FFFD; control characters are omitted.
std::u32string codePointsOf(std::string_view utf8);

/// The typeface of Platon, compiled into the program: Quicksand, and DejaVu Sans for what Quicksand lacks. Digits have
/// one advance, so that a running time stands still. The size of text is the distance between the baselines of two
/// lines; +y is up.
class Typeface {
 public:
  /// A step along the outline of a glyph, from the pen position on the baseline, at size 1. A move begins a closed
  /// curve.
  struct OutlineStep {
    enum class Kind { kMove, kLine, kCurve };
    Kind kind = Kind::kMove;
    glm::vec2 to{0};
    glm::vec2 control{0};  ///< of a kCurve, which is a quadratic Bézier curve

    friend bool operator==(const OutlineStep&, const OutlineStep&) = default;
  };

  Typeface();
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  /// The outline of a glyph; empty for a blank. The outlines of a glyph wind round what is filled.
  std::vector<OutlineStep> outline(char32_t codePoint) const;
  /// Horizontal distance to the next glyph, at size 1.
  float advance(char32_t codePoint) const;
  /// Width of a line of text, at size 1.
  float width(std::string_view utf8) const;
  /// Height of a capital letter at size 1.
  static constexpr float kCapitalHeight = 0.644F;

 protected:
  /// A glyph in a font file of stb_truetype.
  struct Source {
    const stbtt_fontinfo* file = nullptr;
    int glyph = 0;      ///< of the file; 0 is a box
    float scale = 1;    ///< from the units of the file to size 1
    float advance = 0;  ///< at size 1
    float shift = 0;    ///< of the outline to the right, at size 1
  };
  Source source(char32_t codePoint) const;

 private:
  // The first one that has a glyph draws it, else the last one.
  std::array<std::unique_ptr<stbtt_fontinfo>, 2> files_;
  std::array<float, 2> scales_{};  // from the units of the files to size 1
  float digitAdvance_ = 0;         // at size 1
};

}  // namespace platon
