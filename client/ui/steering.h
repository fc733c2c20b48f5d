#pragma once

#include <cstdint>

#include "platon/game/input.h"

namespace platon {

/// Whose left and right the keys mean. The two differ while the camera rolls.
enum class ControlFrame : std::uint8_t { kPlayer, kScreen };

/// What is held down. Directions are those of the keys.
struct HeldKeys {
  bool left = false;
  bool right = false;
  bool up = false;
  bool down = false;
  bool jump = false;
  bool restart = false;
};

/// Turns held keys into the player's buttons.
class Steering {
 public:
  /// `roll` is Camera::rollOf the player. Relative to the screen, a direction keeps its meaning until all are let go:
  /// otherwise running over an edge would turn round.
  Input input(const HeldKeys& keys, double roll, ControlFrame frame);

 private:
  int quarters_ = 0;  // that the player is turned on the screen, counter-clockwise, as the held keys take it
};

}  // namespace platon
