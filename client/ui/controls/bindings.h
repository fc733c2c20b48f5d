#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "client/ui/controls/control.h"
#include "client/ui/key.h"

namespace platon {

/// The keys of a control. The second key is set only if the first one is.
struct ControlKeys {
  std::optional<Key> first;
  std::optional<Key> second;
  std::optional<Key> pad;  ///< button of the gamepad

  friend bool operator==(const ControlKeys&, const ControlKeys&) = default;
};

/// Which keys and buttons each control has. Each of them belongs to at most one control.
class Bindings {
 public:
  /// The defaults.
  Bindings();

  const ControlKeys& keysOf(Control control) const { return keys_[static_cast<std::size_t>(control)]; }
  /// The control that has the key.
  std::optional<Control> controlOf(Key key) const;
  /// Whether one of the control's keys is in `down`.
  bool isAny(Control control, const std::bitset<kKeyCount>& down) const;

  /// Gives the key to the control. A key of the keyboard becomes its first one, and the one that was first its second.
  /// Returns the other control that had the key before. The key can be bound (key_names.h).
  std::optional<Control> bind(Control control, Key key);
  /// Takes all keys from the control.
  void clear(Control control) { at(control) = {}; }

  friend bool operator==(const Bindings&, const Bindings&) = default;

 private:
  ControlKeys& at(Control control) { return keys_[static_cast<std::size_t>(control)]; }
  void remove(Control control, Key key);

  std::array<ControlKeys, kControlCount> keys_;  // by Control
};

}  // namespace platon
