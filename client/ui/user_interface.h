#pragma once

#include <optional>
#include <utility>

#include "client/scene/camera_controls.h"
#include "client/ui/controls/input_mapper.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/key.h"
#include "client/ui/settings.h"

namespace platon {

/// What keys change besides the ball, and the keys that are held.
class UserInterface {
 public:
  explicit UserInterface(const Settings& settings) : settings_(settings) {}

  /// `menuOpen`: the event belongs to the menu; keys that act everywhere act all the same. Returns what the
  /// player asks for; help, net graph and full screen have been changed already.
  std::optional<Action> handle(const KeyEvent& event, bool menuOpen);
  /// Returns the controls of the next tick; none while the menu is open. Called once a tick.
  HeldKeys takeHeld(bool menuOpen);
  /// Returns the player to the start in the next tick, as the key for it does.
  void restart() { restart_ = true; }

  /// Call when the gamepad that was used last was disconnected. Returns whether the player has used it later than the
  /// keyboard, and names the keys of the keyboard from now on.
  bool loseGamepad() { return std::exchange(gamepadUsed_, false); }

  /// How the player looks round.
  LookInput look() const { return mapper_.look(); }
  /// The keys to name on the screen.
  KeyHints keyHints() const { return KeyHints(settings_.bindings, gamepadUsed_); }

  Settings& settings() { return settings_; }
  const Settings& settings() const { return settings_; }
  bool helpShown() const { return helpShown_; }

 private:
  Settings settings_;
  InputMapper mapper_;
  bool helpShown_ = false;
  bool restart_ = false;
  bool gamepadUsed_ = false;  // later than the keyboard
};

}  // namespace platon
