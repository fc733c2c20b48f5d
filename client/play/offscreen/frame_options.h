#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// Options for writing the frames of a game that the demonstration plays without server, window or clock.
struct FrameOptions {
  std::string folder;          ///< for 0000.png, 0001.png …; empty: no frames
  int perSecond = 30;          ///< divides kTicksPerSecond
  double from = 0;             ///< seconds of play before the first frame
  std::uint32_t width = 1280;  ///< pixels; the height is 9/16 of it
  double zoom = 1;             ///< of the camera, 0.5 … 2
  std::uint32_t players = 1;   ///< each starts a second after the one before; the camera follows the first
};

}  // namespace platon
