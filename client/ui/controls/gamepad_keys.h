#pragma once

#include <bitset>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "client/ui/controls/gamepad_state.h"
#include "client/ui/key.h"

namespace platon {

/// Turns successive states of the gamepads into key events.
class GamepadKeys {
 public:
  /// Deflection of the stick to the left or right from which it counts as pressed, and up to which the player creeps
  /// and walks.
  static constexpr float kDeadZone = 0.25F;
  static constexpr float kCreep = 0.5F;
  static constexpr float kWalk = 0.8F;
  /// Deflection of the right stick from which the view turns.
  static constexpr float kLookDeadZone = 0.3F;
  /// Deflection up or down from which it counts as pressed. Larger, so that nobody falls faster by running.
  static constexpr float kVerticalDeadZone = 0.5F;

  /// Returns the changes since the last call. A key is down while it is down on any of `gamepads`; a gamepad that is
  /// disconnected releases its keys.
  std::vector<KeyEvent> update(std::span<const GamepadState> gamepads);

  /// Whether the gamepad on which a key was down last has been disconnected since the last call.
  bool takeLost() { return std::exchange(lost_, false); }

 private:
  void noteUsed(std::span<const GamepadState> gamepads);

  std::bitset<kKeyCount> down_;
  std::optional<int> used_;  // id of the gamepad on which a key was down last
  bool lost_ = false;
};

}  // namespace platon
