#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

#include "client/scene/camera_controls.h"
#include "client/ui/controls/bindings.h"
#include "client/ui/controls/held_keys.h"
#include "client/ui/controls/toggled_controls.h"
#include "client/ui/key.h"

namespace platon {

/// What a key does to the user interface.
enum class Action : std::uint8_t {
  kOpenMenu,
  kToggleHelp,
  kToggleNetGraph,
  kToggleFullscreen,
  kToggleVote,
  kGoOn,
  kWatchNext,
  kSay,
  kTakePicture
};

/// Decides what each key does: an action of the user interface, a control of the game, or both.
class InputMapper {
 public:
  /// From now on the controls have these keys. A toggled control that is on stays on.
  void configure(const Bindings& bindings, const ToggledControls& toggled);

  /// Returns the action of the event, if it has one. While the menu is open, a press is not passed to the game, and
  /// neither is the rest of that press after the menu has closed. Key repeat has no action.
  std::optional<Action> handle(const KeyEvent& event, bool menuOpen);

  /// Returns the controls of the next tick: the held ones, and those pressed since the last call even if they have
  /// been released again. While the player looks round by keys, the directions move the view, not the player. Called
  /// once a tick.
  HeldKeys takeHeld();

  /// How the player looks round: with its key and a direction, or with the right stick.
  LookInput look() const;

 private:
  std::optional<Action> press(const KeyEvent& event, bool menuOpen);
  bool looksByKeys() const;

  Bindings bindings_;
  ToggledControls toggled_;
  bool slow_ = false;  // toggled on, as the next one
  bool looking_ = false;
  std::bitset<kKeyCount> held_;     // pressed while the menu was closed, not released yet
  std::bitset<kKeyCount> pressed_;  // since the last takeHeld
};

}  // namespace platon
