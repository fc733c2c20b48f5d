#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/text_scale.h"

namespace platon {

namespace overlay_colours {

inline constexpr glm::vec4 kBright{0.97F, 0.97F, 1.0F, 1.0F};
inline constexpr glm::vec4 kSoft{0.72F, 0.76F, 0.86F, 1.0F};
inline constexpr glm::vec4 kGold{1.0F, 0.85F, 0.40F, 1.0F};
inline constexpr glm::vec4 kWarning{1.0F, 0.55F, 0.42F, 1.0F};
inline constexpr glm::vec4 kGood{0.50F, 0.90F, 0.62F, 1.0F};
inline constexpr glm::vec4 kPanel{0.04F, 0.05F, 0.09F, 0.80F};
inline constexpr glm::vec4 kSelected{0.24F, 0.34F, 0.60F, 0.85F};

}  // namespace overlay_colours

/// Builds an overlay. Text positions are on the baseline. No text is smaller than kSmallestText.
class OverlayWriter {
 public:
  explicit OverlayWriter(const Font& font) : font_(&font) {}

  void panel(glm::vec2 low, glm::vec2 high, float radius, glm::vec4 colour) {
    overlay_.panels.push_back({low, high, radius, colour});
  }
  void left(std::string text, glm::vec2 place, float size, glm::vec4 colour) {
    overlay_.texts.push_back({place, atLeast(size), colour, std::move(text)});
  }
  void right(const std::string& text, glm::vec2 place, float size, glm::vec4 colour) {
    left(text, {place.x - width(text, size), place.y}, size, colour);
  }
  void centred(const std::string& text, glm::vec2 place, float size, glm::vec4 colour) {
    left(text, {place.x - width(text, size) / 2, place.y}, size, colour);
  }
  /// Text centred on a panel that fits it.
  void pill(const std::string& text, glm::vec2 middle, float size, glm::vec4 colour) {
    pill(std::vector<std::string>{text}, middle, size, colour);
  }
  /// Text on a panel that fits it and begins at `left`. Returns the right end of the panel.
  float pillFrom(float left, const std::string& text, float middle, float size, glm::vec4 colour) {
    const float half = width(text, size) / 2 + size;
    pill(text, {left + half, middle}, size, colour);
    return left + 2 * half;
  }
  /// Lines on a panel that fits them. `middle` is the middle of the last line. Returns the top of the panel.
  float pill(const std::vector<std::string>& lines, glm::vec2 middle, float size, glm::vec4 colour) {
    const float above = kLineDistance * size * static_cast<float>(lines.size() - 1);
    float widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, width(line, size));
    const glm::vec2 half(widest / 2 + size, size * 0.9F);
    const glm::vec2 low = middle - half - glm::vec2(0, above);
    panel(low, middle + half, half.y, overlay_colours::kPanel);
    glm::vec2 place(middle.x, middle.y - above + size * Font::kCapitalHeight / 2);
    for (const std::string& line : lines) {
      centred(line, place, size, colour);
      place.y += kLineDistance * size;
    }
    return low.y;
  }

  float width(const std::string& text, float size) const { return font_->width(text) * atLeast(size); }
  Overlay take() { return std::move(overlay_); }

 private:
  static float atLeast(float size) { return std::max(size, kSmallestText); }

  static constexpr float kLineDistance = 1.3F;  // of two baselines, at size 1

  const Font* font_;
  Overlay overlay_;
};

}  // namespace platon
