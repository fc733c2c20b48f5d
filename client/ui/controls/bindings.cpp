#include "client/ui/controls/bindings.h"

#include <array>
#include <cstddef>
#include <utility>

namespace platon {
namespace {

struct ControlName {
  std::string_view word;
  std::string_view shown;
};

// By Control.
constexpr std::array<ControlName, kControlCount> kControlNames{{{"left", "Run left"},
                                                                {"right", "Run right"},
                                                                {"up", "Up, or jump"},
                                                                {"down", "Down, or fall faster"},
                                                                {"jump", "Jump"},
                                                                {"slow", "Run slower"},
                                                                {"restart", "Back to the start"},
                                                                {"vote", "Next level, or vote"},
                                                                {"look", "Look round"},
                                                                {"watch", "Watch another player"},
                                                                {"say", "Talk to all players"}}};

bool has(const ControlKeys& keys, Key key) { return keys.first == key || keys.second == key || keys.pad == key; }

}  // namespace

std::string_view nameOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].shown; }

std::string_view wordOf(Control control) { return kControlNames[static_cast<std::size_t>(control)].word; }

std::optional<Control> controlNamed(std::string_view word) {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (kControlNames[i].word == word) return static_cast<Control>(i);
  }
  return std::nullopt;
}

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
