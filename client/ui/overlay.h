#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/ui/font.h"

namespace platon {

/// Panels and text in front of the scene. Positions are on a virtual screen that is 720 high, +y down.
struct Overlay {
  static constexpr float kHeight = 720;
  /// Width of the virtual screen for a picture of w × h pixels, both at least 1.
  static float widthFor(std::uint32_t w, std::uint32_t h) {
    return kHeight * static_cast<float>(w) / static_cast<float>(h);
  }

  /// A rectangle with rounded corners.
  struct Panel {
    glm::vec2 low{0};
    glm::vec2 high{0};
    float radius = 0;
    glm::vec4 colour{1};  ///< with opacity
  };
  /// One line of text.
  struct Text {
    glm::vec2 place{0};  ///< left end of the baseline
    float size = 16;
    glm::vec4 colour{1};
    std::string content;  ///< UTF-8
  };

  std::vector<Panel> panels;  ///< drawn first, in order
  std::vector<Text> texts;
};

/// Smallest text of an overlay before it is scaled. OverlayWriter writes no smaller one.
inline constexpr float kSmallestText = 16;
/// Smallest size of a text in pixels of the picture; its letters are those of a font of 11 pixels.
inline constexpr float kSmallestTextPixels = 12;

/// How much menus and display are enlarged in a picture that is `height` pixels high, at least 1: as Settings::uiScale
/// says, or more where texts would be too small.
inline float textScale(double uiScale, std::uint32_t height) {
  const float pixels = static_cast<float>(height) / Overlay::kHeight;  // of a unit
  return std::max(static_cast<float>(uiScale), kSmallestTextPixels / (kSmallestText * pixels));
}

/// The overlay with all lengths multiplied, as seen from the upper left corner of the screen.
inline Overlay scaledBy(Overlay overlay, float factor) {
  for (Overlay::Panel& panel : overlay.panels) {
    panel.low *= factor;
    panel.high *= factor;
    panel.radius *= factor;
  }
  for (Overlay::Text& text : overlay.texts) {
    text.place *= factor;
    text.size *= factor;
  }
  return overlay;
}

/// Makes dark panels black and all panels opaque, and the colours of texts as bright as they can be.
void raiseContrast(Overlay& overlay);

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
