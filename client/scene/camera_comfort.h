#pragma once

namespace platon {

/// The player's choice of how the camera turns.
struct CameraComfort {
  double turnSpeed = 7;        ///< rate of the exponential approach to the player's roll, per second, 1 … 30
  bool instantCut = false;     ///< no swing and no roll: the camera jumps to its target
  bool reducedMotion = false;  ///< limits the roll to Camera::kSlowRoll radians a second
};

}  // namespace platon
