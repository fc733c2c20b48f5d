#pragma once

#include "client/ui/control_frame.h"
#include "client/ui/controls/held_keys.h"
#include "platon/game/input.h"

namespace platon {

/// Turns held keys into the player's input.
class Steering {
 public:
  /// `roll` is Camera::rollOf(player). In ControlFrame::kScreen, the held directions keep their meaning until all of
  /// them are released; otherwise a player who runs over an edge would turn round.
  Input input(const HeldKeys& keys, double roll, ControlFrame frame);

 private:
  int quarters_ = 0;  // counter-clockwise quarter turns of the player on the screen when the held keys were pressed
};

}  // namespace platon
