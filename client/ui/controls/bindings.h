#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "client/ui/key.h"

namespace platon {

/// What the player does in a game by keys that can be chosen.
enum class Control : std::uint8_t {
  kLeft,
  kRight,
  kUp,  ///< jumps; with controls relative to the screen, moves upwards on it
  kDown,
  kJump,
  kSlow,
  kRestart,
  kVote,
  kLook,
  kWatch,
  kSay
};
inline constexpr std::size_t kControlCount = static_cast<std::size_t>(Control::kSay) + 1;

/// What the control does, for the player.
std::string_view nameOf(Control control);
/// The name of the control in the settings file.
std::string_view wordOf(Control control);
/// The control with this name in the settings file.
std::optional<Control> controlNamed(std::string_view word);

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
  /// Returns the other control that had the key before. The key can be bound (canBeBound).
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
