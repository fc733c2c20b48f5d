#include "client/ui/controls/bindings.h"

#include <cstddef>
#include <utility>

namespace platon {
namespace {

bool has(const ControlKeys& keys, Key key) { return keys.first == key || keys.second == key || keys.pad == key; }

}  // namespace

Bindings::Bindings()
    : keys_{{{Key::kArrowLeft, Key::kA, Key::kPadLeft},
             {Key::kArrowRight, Key::kD, Key::kPadRight},
             {Key::kArrowUp, Key::kW, {}},  // not the gamepad's: pushing the stick up must not jump
             {Key::kArrowDown, Key::kS, Key::kPadDown},
             {Key::kSpace, {}, Key::kPadA},
             {Key::kShift, {}, Key::kPadLeftBumper},
             {Key::kR, {}, Key::kPadBack},
             {Key::kV, {}, Key::kPadY},
             {Key::kTab, {}, {}},  // the right stick looks round
             {Key::kE, {}, Key::kPadRightBumper},
             {Key::kT, {}, Key::kPadX}}} {}

std::optional<Control> Bindings::controlOf(Key key) const {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (has(keys_[i], key)) return static_cast<Control>(i);
  }
  return std::nullopt;
}

bool Bindings::isAny(Control control, const std::bitset<kKeyCount>& down) const {
  const auto isDown = [&down](std::optional<Key> key) { return key && down[static_cast<std::size_t>(*key)]; };
  const ControlKeys& keys = keysOf(control);
  return isDown(keys.first) || isDown(keys.second) || isDown(keys.pad);
}

std::optional<Control> Bindings::bind(Control control, Key key) {
  const std::optional<Control> owner = controlOf(key);
  if (owner) remove(*owner, key);
  ControlKeys& keys = at(control);
  if (isOfGamepad(key))
    keys.pad = key;
  else
    keys.second = std::exchange(keys.first, key);
  return owner == control ? std::nullopt : owner;
}

void Bindings::remove(Control control, Key key) {
  ControlKeys& keys = at(control);
  if (keys.pad == key) keys.pad.reset();
  if (keys.first == key) keys.first = std::exchange(keys.second, std::nullopt);
  if (keys.second == key) keys.second.reset();
}

}  // namespace platon
