#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace platon {

/// What the camera does while the player moves on a face.
enum class CameraView : std::uint8_t {
  kFollow,   ///< it follows the player
  kFace,     ///< it stands still, and cuts to the next face at an edge
  kFaceFade  ///< as kFace, but the picture fades to the next face
};

/// The player's choice of how the camera moves.
struct CameraComfort {
  double turnRate = 7;         ///< of the exponential approach to the player's roll, per second, 1 … 30; see maxRoll
  bool instantCut = false;     ///< no swing, roll or flight: the camera jumps to its target
  bool reducedMotion = false;  ///< slower swing and roll, no look-ahead, no flight; nothing moves but the players
  CameraView view = CameraView::kFollow;

  /// Largest roll, radians a second: as fast as the approach to a roll that is one radian away.
  double maxRoll() const { return turnRate; }
};

/// How the player looks round the solid.
struct LookInput {
  bool held = false;        ///< the view turns; without it, it goes back
  glm::dvec2 direction{0};  ///< to the right and upwards, each -1 … 1
  glm::dvec2 turn{0};       ///< by which the view turns at once, while held: to the right and upwards, radians

  friend bool operator==(const LookInput&, const LookInput&) = default;
};

}  // namespace platon
