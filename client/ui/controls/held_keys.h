#pragma once

namespace platon {

/// Controls of the game that are held during a tick. Directions are those of the keys, before Steering.
struct HeldKeys {
  bool left = false;
  bool right = false;
  bool up = false;
  bool down = false;
  bool jump = false;
  bool walk = false;   ///< two thirds of the run speed
  bool creep = false;  ///< one third
  bool restart = false;

  friend bool operator==(const HeldKeys&, const HeldKeys&) = default;
};

}  // namespace platon
