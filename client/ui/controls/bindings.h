#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
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
  kSay,
  kEmote1,  ///< the emotes are in the order of their numbers
  kEmote2,
  kEmote3,
  kEmote4
};
inline constexpr std::size_t kControlCount = static_cast<std::size_t>(Control::kEmote4) + 1;

/// What the control does, for the player.
std::string_view nameOf(Control control);
/// The name of the control in the settings file.
std::string_view wordOf(Control control);
/// The control with this name in the settings file.
std::optional<Control> controlNamed(std::string_view word);

/// Whose keys: those of the first player with the buttons of all gamepads, or those of the second player at the
/// keyboard.
enum class KeySet : std::uint8_t { kFirst, kSecond };

/// Whether the control can have keys of the set: companions move their balls and show emotes, all else belongs to the
/// first player.
constexpr bool isOfSet(Control control, KeySet set) {
  return set == KeySet::kFirst || control <= Control::kRestart || control >= Control::kEmote1;
}

/// The frame that left and right refer to. The two frames differ while the camera rolls.
enum class ControlFrame : std::uint8_t { kPlayer, kScreen };

/// Controls that a press turns on and the next press off; the others act while a key is held.
struct ToggledControls {
  bool slow = false;
  bool look = false;
};

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
  /// The defaults. Those of the second player are the arrows and two keys beside them.
  Bindings() : Bindings(KeySet::kFirst) {}
  explicit Bindings(KeySet set);

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

  /// These bindings without the keys of the keyboard that `other` has.
  Bindings without(const Bindings& other) const;

  friend bool operator==(const Bindings&, const Bindings&) = default;

 private:
  ControlKeys& at(Control control) { return keys_[static_cast<std::size_t>(control)]; }
  void remove(Control control, Key key);

  std::array<ControlKeys, kControlCount> keys_;  // by Control
};

/// The first word of the lines of a set in the settings file.
constexpr std::string_view wordOf(KeySet set) { return set == KeySet::kFirst ? "key" : "key2"; }

/// The bindings as lines `key CONTROL KEY…` of the settings file, `none` for no key; `key2` for the second player.
std::string textOf(const Bindings& bindings, KeySet set = KeySet::kFirst);

/// Reads such lines, in any order. A line takes its keys over from controls that have no line before it.
class BindingsReader {
 public:
  explicit BindingsReader(KeySet set = KeySet::kFirst) : set_(set), bindings_(set) {}

  /// Gives the control of a line these keys, which are the words after it. Returns what is wrong with them, and changes
  /// nothing then; else an empty text.
  std::string read(Control control, std::span<const std::string> words);

  const Bindings& bindings() const { return bindings_; }

 private:
  std::string faultOf(Control control, const ControlKeys& keys) const;

  KeySet set_;
  Bindings bindings_;
  std::bitset<kControlCount> read_;  // the controls that had a line
};

}  // namespace platon
