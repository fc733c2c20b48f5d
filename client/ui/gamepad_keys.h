#pragma once

#include <bitset>
#include <span>
#include <vector>

#include "client/ui/gamepad_state.h"
#include "client/ui/key.h"

namespace platon {

/// Turns successive states of the gamepads into key events.
class GamepadKeys {
 public:
  /// Deflection of the stick from which it counts as pressed.
  static constexpr float kDeadZone = 0.4F;

  /// Returns the changes since the last call. A key is down while it is down on any of `gamepads`; a gamepad that is
  /// disconnected releases its keys.
  std::vector<KeyEvent> update(std::span<const GamepadState> gamepads);

 private:
  std::bitset<kKeyCount> down_;
};

}  // namespace platon
