#pragma once

#include <cstdint>

namespace platon {

/// What the camera does while the player moves on a face.
enum class CameraView : std::uint8_t {
  kFollow,   ///< it follows the player
  kFace,     ///< it stands still, and cuts to the next face at an edge
  kFaceFade  ///< as kFace, but the picture fades to the next face
};

/// The player's choice of how the camera moves.
struct CameraComfort {
  double turnSpeed = 7;        ///< rate of the exponential approach to the player's roll, per second, 1 … 30
  bool instantCut = false;     ///< no swing, roll or flight: the camera jumps to its target
  bool reducedMotion = false;  ///< slower swing and roll, no look-ahead, no flight; nothing moves but the players
  CameraView view = CameraView::kFollow;
};

}  // namespace platon
