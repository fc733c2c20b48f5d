#pragma once

#include <algorithm>
#include <cstdint>

#include "client/ui/overlay.h"

namespace platon {

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

}  // namespace platon
