#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "client/ui/controls/bindings.h"
#include "client/ui/key.h"

namespace platon {

/// What the player reads on the key or button: `Space`, `←`, `LB`.
std::string_view shownNameOf(Key key);

/// The name of the key in the settings file: `space`, `arrow-left`, `pad-lb`. Empty for keys that no control can have:
/// those of the menus and of the program, and what is only a tilt of a stick.
std::string_view wordOf(Key key);

/// The key with this name in the settings file.
std::optional<Key> keyNamed(std::string_view word);

/// Whether a control of the game can have the key.
inline bool canBeBound(Key key) { return !wordOf(key).empty(); }

/// Tells the player which keys to press. All texts on the screen that name a key have the name from here.
class KeyHints {
 public:
  /// `gamepad`: the player has used the gamepad last, so its buttons are named as far as there are any.
  explicit KeyHints(const Bindings& bindings = {}, bool gamepad = false) : bindings_(bindings), gamepad_(gamepad) {}

  /// One key of the control: `Space`; `no key` if it has none.
  std::string of(Control control) const;
  /// What a key of the control does: `R: back to the start`.
  std::string to(Control control, const std::string& what) const;
  /// One key for each side: `← →`.
  std::string sides() const;
  /// The keys that run to both sides: `← → or A D`.
  std::string run() const;

  /// What lets another player of this machine join: `F2`, or with `RT` on the gamepad unless a control has it.
  std::string join() const;
  /// The button of the gamepad that does; empty if a control has it.
  std::string joinPad() const;
  /// What looks round the solid: `Hold Tab and press arrows`.
  std::string look() const;
  /// The keys that say which way: `arrows`, or those that run if another player has them.
  std::string lookWays() const;
  /// The key that leads to the next level after the goal.
  std::string goOn() const;
  /// The key that pauses and opens the menu.
  std::string menu() const;
  /// Whether buttons of the gamepad are named.
  bool gamepad() const { return gamepad_; }

  /// All keys of the control: `Space or J`; empty if it has none.
  std::string keys(Control control) const;
  /// Its button of the gamepad; empty if it has none.
  std::string pad(Control control) const;

 private:
  Bindings bindings_;
  bool gamepad_;
};

}  // namespace platon
