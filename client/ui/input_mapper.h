#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

#include "client/scene/look_input.h"
#include "client/ui/held_keys.h"
#include "client/ui/key.h"

namespace platon {

/// What a key does to the user interface.
enum class Action : std::uint8_t {
  kOpenMenu,
  kToggleHelp,
  kToggleNetGraph,
  kToggleFullscreen,
  kToggleVote,
  kWatchNext,
  kSay,
  kTakePicture
};

/// Decides what each key does: an action of the user interface, a control of the game, or both.
class InputMapper {
 public:
  /// Returns the action of the event, if it has one. While the menu is open, a press is not passed to the game, and
  /// neither is the rest of that press after the menu has closed. Key repeat has no action.
  std::optional<Action> handle(const KeyEvent& event, bool menuOpen);

  /// Returns the controls of the next tick: the held ones, and those pressed since the last call even if they have
  /// been released again. While Tab is held, the arrow keys and those beside them move the view, not the player. Called
  /// once a tick.
  HeldKeys takeHeld();

  /// How the player looks round: with Tab and a direction, or with the right stick.
  LookInput look() const;

 private:
  std::bitset<kKeyCount> held_;     // pressed while the menu was closed, not released yet
  std::bitset<kKeyCount> pressed_;  // since the last takeHeld
};

}  // namespace platon
