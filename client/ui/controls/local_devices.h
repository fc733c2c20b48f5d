#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "client/ui/controls/bindings.h"
#include "client/ui/key.h"
#include "protocol/limits.h"

namespace platon {

/// What LocalDevices::toggle has done.
enum class DeviceChange : std::uint8_t {
  kJoined,
  kLeft,
  kReturned,  ///< a companion whose gamepad was lost has this device now
  kNone       ///< nobody more can play
};

/// Who plays at this machine, and with what. The first player has the keyboard and all gamepads; a companion takes the
/// keys of `secondKeys` or one gamepad away from it as long as it plays.
class LocalDevices {
 public:
  /// The local number of the player who has the key. `secondKeys`: those of the second player at the keyboard.
  std::uint32_t ownerOf(const KeyEvent& event, const Bindings& secondKeys) const;
  /// The second half of the keyboard, if `event` is a key of the keyboard, or the gamepad of the event joins: it gets
  /// the companion whose gamepad is lost, or the lowest free local number. If it plays already, its player leaves.
  DeviceChange toggle(const KeyEvent& event);
  /// Call with each event: a lost gamepad that is used again plays on.
  void observe(const KeyEvent& event);
  /// The gamepad is disconnected. Its companion stays, and waits for this one or another. Returns whether there is one.
  bool lose(int pad);
  /// The companion leaves.
  void remove(std::uint32_t local) { devices_[local].reset(); }
  /// Whether a companion plays under a local number.
  bool has(std::uint32_t local) const { return devices_[local].has_value(); }
  /// Whether the companion under a local number plays with a gamepad.
  bool hasGamepad(std::uint32_t local) const { return has(local) && devices_[local]->id != kKeyboard; }
  /// Whether somebody has the second half of the keyboard.
  bool sharesKeyboard() const { return find(kKeyboard).has_value(); }

 private:
  static constexpr int kKeyboard = -1;  // no id of a gamepad

  struct Device {
    int id = kKeyboard;
    bool isLost = false;
  };

  std::optional<std::uint32_t> find(int id) const;

  std::array<std::optional<Device>, kMaxLocalPlayers> devices_;  // of companions, by local number
};

}  // namespace platon
