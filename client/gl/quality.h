#pragma once

#include <string_view>

namespace platon {

/// What the picture of the game may cost.
struct Quality {
  int samples = 1;        ///< per pixel: 1, 2 or 4, limited by the driver
  double scale = 1;       ///< of the picture of the scene, 0.75 … 1; text and overlays keep the size of the picture
  bool shadows = true;    ///< of walls
  bool particles = true;  ///< trails, dust and motes in the sky

  friend bool operator==(const Quality&, const Quality&) = default;
};

/// Everything on.
inline constexpr Quality kBestQuality{4, 1, true, true};

/// The quality for the driver with this GL_RENDERER. A driver that draws with the processor gets one sample per pixel:
/// four would take more than twice the time.
Quality qualityFor(std::string_view renderer);

/// qualityFor() the driver of the current context.
Quality defaultQuality();

}  // namespace platon
