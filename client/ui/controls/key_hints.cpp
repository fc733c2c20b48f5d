#include "client/ui/controls/key_hints.h"

#include <optional>

#include "client/ui/controls/key_names.h"

namespace platon {
namespace {

std::string nameOf(std::optional<Key> key) { return key ? std::string(shownNameOf(*key)) : std::string(); }

std::string joined(const std::string& a, const std::string& between, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + between + b;
}

}  // namespace

std::string KeyHints::of(Control control) const {
  const ControlKeys& keys = bindings_.keysOf(control);
  const std::string button = nameOf(keys.pad);
  const std::string key = nameOf(keys.first);
  const std::string& name = !button.empty() && (gamepad_ || key.empty()) ? button : key;
  return name.empty() ? "no key" : name;
}

std::string KeyHints::to(Control control, const std::string& what) const { return of(control) + ": " + what; }

std::string KeyHints::goOn() const {
  const std::string button = pad(Control::kVote);
  if (gamepad_ && !button.empty()) return button;
  return bindings_.controlOf(Key::kEnter) ? of(Control::kVote) : "Enter";
}

std::string KeyHints::menu() const { return std::string(shownNameOf(gamepad_ ? Key::kPadStart : Key::kEscape)); }

std::string KeyHints::run() const {
  const ControlKeys& left = bindings_.keysOf(Control::kLeft);
  const ControlKeys& right = bindings_.keysOf(Control::kRight);
  if (gamepad_ && left.pad && right.pad) return nameOf(left.pad) + " " + nameOf(right.pad);
  const std::string second = left.second && right.second ? nameOf(left.second) + " " + nameOf(right.second) : "";
  return joined(of(Control::kLeft) + " " + of(Control::kRight), " or ", second);
}

std::string KeyHints::keys(Control control) const {
  const ControlKeys& keys = bindings_.keysOf(control);
  return joined(nameOf(keys.first), " or ", nameOf(keys.second));
}

std::string KeyHints::pad(Control control) const { return nameOf(bindings_.keysOf(control).pad); }

}  // namespace platon
