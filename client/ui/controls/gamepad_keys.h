#pragma once

#include <bitset>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "client/ui/key.h"
#include "protocol/time.h"

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

  /// Returns the changes since the last call. A gamepad that is disconnected releases its keys.
  std::vector<KeyEvent> update(std::span<const GamepadState> gamepads);

  /// The ids of the gamepads with which somebody has played and that have been disconnected since the last call.
  std::vector<int> takeLost() { return std::exchange(lost_, {}); }

 private:
  struct Known {
    std::bitset<kKeyCount> down;
    bool used = false;  // a key was down
  };

  std::map<int, Known> known_;  // the connected gamepads by id
  std::vector<int> lost_;
};

/// Repeats the direction of the gamepad that is held, as keyboards repeat their keys.
class PadRepeat {
 public:
  static constexpr Time kDelay = std::chrono::milliseconds(400);    ///< from the press to the first repetition
  static constexpr Time kInterval = std::chrono::milliseconds(80);  ///< between two of them

  /// Call with each event.
  void observe(const KeyEvent& event, Time now);
  /// The repetition of the direction that was pressed last, if it is due. A direction that is not repeated now, such as
  /// one that moves the ball, is repeated only after it is pressed again.
  std::optional<KeyEvent> repeat(bool repeats, Time now);

 private:
  std::optional<Key> held_;
  Time next_{};  // when held_ is repeated
};

}  // namespace platon
