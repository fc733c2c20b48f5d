#include "client/ui/controls/gamepad_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace platon {
namespace {

std::bitset<kKeyCount> keysOf(const GamepadState& pad) {
  const float tilt = pad.dpadLeft || pad.dpadRight ? 1 : std::abs(pad.stickX);
  const std::array<std::pair<Key, bool>, 22> states{
      {{Key::kPadLeft, pad.dpadLeft || pad.stickX < -GamepadKeys::kDeadZone},
       {Key::kPadRight, pad.dpadRight || pad.stickX > GamepadKeys::kDeadZone},
       {Key::kPadUp, pad.dpadUp || pad.stickY < -GamepadKeys::kVerticalDeadZone},
       {Key::kPadDown, pad.dpadDown || pad.stickY > GamepadKeys::kVerticalDeadZone},
       {Key::kPadWalk, tilt > GamepadKeys::kCreep && tilt <= GamepadKeys::kWalk},
       {Key::kPadCreep, tilt > GamepadKeys::kDeadZone && tilt <= GamepadKeys::kCreep},
       {Key::kPadLookLeft, pad.lookX < -GamepadKeys::kLookDeadZone},
       {Key::kPadLookRight, pad.lookX > GamepadKeys::kLookDeadZone},
       {Key::kPadLookUp, pad.lookY < -GamepadKeys::kLookDeadZone},
       {Key::kPadLookDown, pad.lookY > GamepadKeys::kLookDeadZone},
       {Key::kPadA, pad.a},
       {Key::kPadB, pad.b},
       {Key::kPadStart, pad.start},
       {Key::kPadBack, pad.back},
       {Key::kPadX, pad.x},
       {Key::kPadY, pad.y},
       {Key::kPadLeftBumper, pad.leftBumper},
       {Key::kPadRightBumper, pad.rightBumper},
       {Key::kPadLeftTrigger, pad.leftTrigger},
       {Key::kPadRightTrigger, pad.rightTrigger},
       {Key::kPadLeftStick, pad.leftStick},
       {Key::kPadRightStick, pad.rightStick}}};
  std::bitset<kKeyCount> keys;
  for (const auto& [key, down] : states) keys.set(static_cast<std::size_t>(key), down);
  return keys;
}

bool isDirection(Key key) {
  return key == Key::kPadLeft || key == Key::kPadRight || key == Key::kPadUp || key == Key::kPadDown;
}

}  // namespace

std::vector<KeyEvent> GamepadKeys::update(std::span<const GamepadState> gamepads) {
  std::vector<KeyEvent> events;
  const auto change = [&events](int pad, Known& known, const std::bitset<kKeyCount>& down) {
    for (std::size_t i = 0; i < kKeyCount; ++i) {
      if (down[i] == known.down[i]) continue;
      const KeyEvent::Kind kind = down[i] ? KeyEvent::Kind::kPress : KeyEvent::Kind::kRelease;
      events.push_back({.key = static_cast<Key>(i), .kind = kind, .pad = pad});
    }
    known.down = down;
    known.used = known.used || down.any();
  };
  for (auto each = known_.begin(); each != known_.end();) {
    const auto isIt = [&each](const GamepadState& pad) { return pad.id == each->first; };
    if (std::any_of(gamepads.begin(), gamepads.end(), isIt)) {
      ++each;
      continue;
    }
    change(each->first, each->second, {});
    if (each->second.used) lost_.push_back(each->first);
    each = known_.erase(each);
  }
  for (const GamepadState& pad : gamepads) change(pad.id, known_[pad.id], keysOf(pad));
  return events;
}

void PadRepeat::observe(const KeyEvent& event, Time now) {
  if (event.kind == KeyEvent::Kind::kRelease && event.key == held_) held_.reset();
  if (event.kind != KeyEvent::Kind::kPress || !isDirection(event.key)) return;
  held_ = event.key;
  next_ = now + kDelay;
}

// Late pictures are not made up for: the focus would leap.
std::optional<KeyEvent> PadRepeat::repeat(bool repeats, Time now) {
  if (!repeats) held_.reset();
  if (!held_ || now < next_) return std::nullopt;
  next_ += kInterval;
  if (next_ <= now) next_ = now + kInterval;
  return KeyEvent{*held_, KeyEvent::Kind::kRepeat};
}

}  // namespace platon
