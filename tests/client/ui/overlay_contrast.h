#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// The relative luminance of WCAG 2, 0 … 1.
inline float luminance(glm::vec3 colour) {
  const auto linear = [](float part) {
    return part <= 0.04045F ? part / 12.92F : std::pow((part + 0.055F) / 1.055F, 2.4F);
  };
  return 0.2126F * linear(colour.r) + 0.7152F * linear(colour.g) + 0.0722F * linear(colour.b);
}

/// The contrast of WCAG 2, 1 … 21.
inline float contrast(glm::vec3 a, glm::vec3 b) {
  const float one = luminance(a) + 0.05F;
  const float other = luminance(b) + 0.05F;
  return std::max(one, other) / std::min(one, other);
}

/// What is left of a picture of this colour behind a text, under the panels that it stands on.
inline glm::vec3 groundOf(const Overlay& overlay, const Overlay::Text& text, const Font& font, glm::vec3 picture) {
  const glm::vec2 middle = text.place - glm::vec2(0, text.size * Font::kCapitalHeight / 2);
  const float right = middle.x + font.width(text.content) * text.size;
  for (const Overlay::Panel& panel : overlay.panels) {
    const bool covers =
        panel.low.x <= middle.x && right <= panel.high.x && panel.low.y <= middle.y && middle.y <= panel.high.y;
    if (covers) picture = glm::mix(picture, glm::vec3(panel.colour), panel.colour.a);
  }
  return picture;
}

}  // namespace platon
