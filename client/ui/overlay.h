#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

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

}  // namespace platon
