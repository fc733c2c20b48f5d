#pragma once

#include <utility>

#include "client/scene/look_input.h"
#include "client/ui/held_keys.h"
#include "client/ui/input_mapper.h"
#include "client/ui/key.h"
#include "client/ui/menu.h"
#include "client/ui/settings.h"

namespace platon {

/// State of menu, settings and help, which the player changes by keys.
class UserInterface {
 public:
  explicit UserInterface(const Settings& settings) : settings_(settings) {}

  void handle(const KeyEvent& event);
  /// Returns the controls of the next tick; none while the menu is open. Called once a tick.
  HeldKeys takeHeld();

  /// How the player looks round; not at all while the menu is open.
  LookInput look() const { return menu_.open() ? LookInput() : mapper_.look(); }

  /// Whether the player has changed its vote for the next level since the last call.
  bool takeVote() { return std::exchange(voteToggled_, false); }

  const Menu& menu() const { return menu_; }
  const Settings& settings() const { return settings_; }
  bool helpShown() const { return helpShown_; }

 private:
  void perform(Action action);

  Settings settings_;
  Menu menu_;
  InputMapper mapper_;
  bool helpShown_ = false;
  bool voteToggled_ = false;
};

}  // namespace platon
