#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "client/scene/camera_controls.h"
#include "client/ui/controls/input_mapper.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/controls/local_devices.h"
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
  /// Returns the controls of a local player in the next tick; none while the menu is open. Called once a tick for each.
  HeldKeys takeHeld(bool menuOpen, std::uint32_t local = 0);
  /// Returns the first player to the start in the next tick, as the key for it does.
  void restart() { restart_ = true; }

  /// Call when this gamepad was disconnected. Returns whether somebody played with it: a companion, or the first player
  /// if it has used it later than anything else. Then it names the keys of the keyboard from now on.
  bool loseGamepad(int pad);

  /// Who plays at this machine.
  const LocalDevices& devices() const { return devices_; }
  /// What the last Action::kJoin has done.
  DeviceChange deviceChange() const { return deviceChange_; }
  /// The companion leaves.
  void removeCompanion(std::uint32_t local);

  /// How the first player looks round.
  LookInput look() const { return mappers_[0].look(); }
  /// The keys of the first player to name on the screen.
  KeyHints keyHints() const { return KeyHints(ownKeys(), padUsed_.has_value()); }
  /// Those of a companion.
  KeyHints companionKeyHints(std::uint32_t local) const {
    return KeyHints(companionKeys(), devices_.hasGamepad(local));
  }

  Settings& settings() { return settings_; }
  const Settings& settings() const { return settings_; }
  /// Shows the help until the key for it hides it.
  void showHelp() { helpShown_ = true; }
  bool helpShown() const { return helpShown_; }

 private:
  void configure();
  Bindings ownKeys() const;
  Bindings companionKeys() const;
  void observe(const KeyEvent& event);
  void join(const KeyEvent& event);

  Settings settings_;
  LocalDevices devices_;
  DeviceChange deviceChange_ = DeviceChange::kNone;
  std::array<InputMapper, kMaxLocalPlayers> mappers_;  // by local number
  std::vector<KeyEvent> down_;                         // the presses of keys that are down, of all devices
  bool helpShown_ = false;
  bool restart_ = false;
  std::optional<int> padUsed_;  // the gamepad that the first player has used later than the keyboard
};

}  // namespace platon
