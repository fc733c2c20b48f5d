#pragma once

namespace platon {

/// State of one gamepad. Buttons have their Xbox names.
struct GamepadState {
  int id = 0;        ///< of the gamepad, as long as it is connected
  float stickX = 0;  ///< left stick, -1 … 1, + right
  float stickY = 0;  ///< -1 … 1, + down
  float lookX = 0;   ///< right stick, -1 … 1, + right
  float lookY = 0;   ///< -1 … 1, + down
  bool dpadLeft = false;
  bool dpadRight = false;
  bool dpadUp = false;
  bool dpadDown = false;
  bool a = false;
  bool b = false;
  bool start = false;
  bool back = false;
  bool x = false;
  bool y = false;
  bool leftBumper = false;
  bool rightBumper = false;
  bool leftTrigger = false;
  bool rightTrigger = false;
  bool leftStick = false;  ///< pressed, as the next one
  bool rightStick = false;
};

}  // namespace platon
