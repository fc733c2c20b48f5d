#include "client/ui/controls/key_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace platon {
namespace {

struct KeyName {
  Key key;
  const char* shown;
  const char* word = "";
};

// In the order of Key, as keyNamesAreInOrder checks.
constexpr std::array<KeyName, kKeyCount> kKeyNames{{{Key::kArrowLeft, "←", "arrow-left"},
                                                    {Key::kArrowRight, "→", "arrow-right"},
                                                    {Key::kArrowUp, "↑", "arrow-up"},
                                                    {Key::kArrowDown, "↓", "arrow-down"},
                                                    {Key::kA, "A", "a"},
                                                    {Key::kD, "D", "d"},
                                                    {Key::kW, "W", "w"},
                                                    {Key::kS, "S", "s"},
                                                    {Key::kSpace, "Space", "space"},
                                                    {Key::kEnter, "Enter", "enter"},
                                                    {Key::kR, "R", "r"},
                                                    {Key::kV, "V", "v"},
                                                    {Key::kShift, "Shift", "shift"},
                                                    {Key::kTab, "Tab", "tab"},
                                                    {Key::kEscape, "Esc"},
                                                    {Key::kF1, "F1"},
                                                    {Key::kF2, "F2", "f2"},
                                                    {Key::kF3, "F3"},
                                                    {Key::kF4, "F4", "f4"},
                                                    {Key::kF5, "F5", "f5"},
                                                    {Key::kF6, "F6", "f6"},
                                                    {Key::kF7, "F7", "f7"},
                                                    {Key::kF8, "F8", "f8"},
                                                    {Key::kF9, "F9", "f9"},
                                                    {Key::kF10, "F10", "f10"},
                                                    {Key::kF11, "F11"},
                                                    {Key::kF12, "F12"},
                                                    {Key::kC, "C", "c"},
                                                    {Key::kE, "E", "e"},
                                                    {Key::kF, "F", "f"},
                                                    {Key::kG, "G", "g"},
                                                    {Key::kH, "H", "h"},
                                                    {Key::kP, "P", "p"},
                                                    {Key::kT, "T", "t"},
                                                    {Key::kX, "X", "x"},
                                                    {Key::kY, "Y", "y"},
                                                    {Key::kZ, "Z", "z"},
                                                    {Key::kB, "B", "b"},
                                                    {Key::kI, "I", "i"},
                                                    {Key::kJ, "J", "j"},
                                                    {Key::kK, "K", "k"},
                                                    {Key::kL, "L", "l"},
                                                    {Key::kM, "M", "m"},
                                                    {Key::kN, "N", "n"},
                                                    {Key::kO, "O", "o"},
                                                    {Key::kQ, "Q", "q"},
                                                    {Key::kU, "U", "u"},
                                                    {Key::kDigit0, "0", "0"},
                                                    {Key::kDigit1, "1", "1"},
                                                    {Key::kDigit2, "2", "2"},
                                                    {Key::kDigit3, "3", "3"},
                                                    {Key::kDigit4, "4", "4"},
                                                    {Key::kDigit5, "5", "5"},
                                                    {Key::kDigit6, "6", "6"},
                                                    {Key::kDigit7, "7", "7"},
                                                    {Key::kDigit8, "8", "8"},
                                                    {Key::kDigit9, "9", "9"},
                                                    {Key::kPlus, "+", "plus"},
                                                    {Key::kMinus, "−", "minus"},
                                                    {Key::kDelete, "Delete"},
                                                    {Key::kBackspace, "Backspace"},
                                                    {Key::kPageUp, "Page Up", "page-up"},
                                                    {Key::kPageDown, "Page Down", "page-down"},
                                                    {Key::kHome, "Home", "home"},
                                                    {Key::kEnd, "End", "end"},
                                                    {Key::kInsert, "Insert", "insert"},
                                                    {Key::kControl, "Ctrl", "ctrl"},
                                                    {Key::kAlt, "Alt", "alt"},
                                                    {Key::kComma, ",", "comma"},
                                                    {Key::kPeriod, ".", "period"},
                                                    {Key::kSlash, "/", "slash"},
                                                    {Key::kSemicolon, ";", "semicolon"},
                                                    {Key::kApostrophe, "'", "apostrophe"},
                                                    {Key::kLeftBracket, "[", "left-bracket"},
                                                    {Key::kRightBracket, "]", "right-bracket"},
                                                    {Key::kBackslash, "\\", "backslash"},
                                                    {Key::kGrave, "`", "grave"},
                                                    {Key::kKeypad0, "Keypad 0", "keypad-0"},
                                                    {Key::kKeypad1, "Keypad 1", "keypad-1"},
                                                    {Key::kKeypad2, "Keypad 2", "keypad-2"},
                                                    {Key::kKeypad3, "Keypad 3", "keypad-3"},
                                                    {Key::kKeypad4, "Keypad 4", "keypad-4"},
                                                    {Key::kKeypad5, "Keypad 5", "keypad-5"},
                                                    {Key::kKeypad6, "Keypad 6", "keypad-6"},
                                                    {Key::kKeypad7, "Keypad 7", "keypad-7"},
                                                    {Key::kKeypad8, "Keypad 8", "keypad-8"},
                                                    {Key::kKeypad9, "Keypad 9", "keypad-9"},
                                                    {Key::kPadLeft, "stick ←", "pad-left"},
                                                    {Key::kPadRight, "stick →", "pad-right"},
                                                    {Key::kPadUp, "stick ↑", "pad-up"},
                                                    {Key::kPadDown, "stick ↓", "pad-down"},
                                                    {Key::kPadWalk, "stick"},
                                                    {Key::kPadCreep, "stick"},
                                                    {Key::kPadLookLeft, "right stick"},
                                                    {Key::kPadLookRight, "right stick"},
                                                    {Key::kPadLookUp, "right stick"},
                                                    {Key::kPadLookDown, "right stick"},
                                                    {Key::kPadA, "pad A", "pad-a"},
                                                    {Key::kPadB, "pad B", "pad-b"},
                                                    {Key::kPadStart, "Start"},
                                                    {Key::kPadBack, "Back", "pad-back"},
                                                    {Key::kPadX, "pad X", "pad-x"},
                                                    {Key::kPadY, "pad Y", "pad-y"},
                                                    {Key::kPadLeftBumper, "LB", "pad-lb"},
                                                    {Key::kPadRightBumper, "RB", "pad-rb"},
                                                    {Key::kPadLeftTrigger, "LT", "pad-lt"},
                                                    {Key::kPadRightTrigger, "RT", "pad-rt"},
                                                    {Key::kPadLeftStick, "LS", "pad-ls"},
                                                    {Key::kPadRightStick, "RS", "pad-rs"}}};

constexpr bool keyNamesAreInOrder() {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    if (static_cast<std::size_t>(kKeyNames[i].key) != i) return false;
  }
  return true;
}
static_assert(keyNamesAreInOrder());

std::string nameOf(std::optional<Key> key) { return key ? std::string(shownNameOf(*key)) : std::string(); }

std::string joined(const std::string& a, const std::string& between, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + between + b;
}

}  // namespace

std::string_view shownNameOf(Key key) { return kKeyNames[static_cast<std::size_t>(key)].shown; }

std::string_view wordOf(Key key) { return kKeyNames[static_cast<std::size_t>(key)].word; }

std::optional<Key> keyNamed(std::string_view word) {
  const auto found =
      std::find_if(kKeyNames.begin(), kKeyNames.end(), [word](const KeyName& name) { return name.word == word; });
  return word.empty() || found == kKeyNames.end() ? std::nullopt : std::optional(found->key);
}

std::string KeyHints::of(Control control) const {
  const ControlKeys& keys = bindings_.keysOf(control);
  const std::string button = nameOf(keys.pad);
  const std::string key = nameOf(keys.first);
  const std::string& name = !button.empty() && (gamepad_ || key.empty()) ? button : key;
  return name.empty() ? "no key" : name;
}

std::string KeyHints::to(Control control, const std::string& what) const { return of(control) + ": " + what; }

std::string KeyHints::join() const {
  const std::string button = joinPad();
  return gamepad_ && !button.empty() ? button : std::string(shownNameOf(Key::kF2));
}

std::string KeyHints::joinPad() const {
  return bindings_.controlOf(Key::kPadRightTrigger) ? "" : std::string(shownNameOf(Key::kPadRightTrigger));
}

std::string KeyHints::look() const {
  if (gamepad_) return std::string(shownNameOf(Key::kPadLookLeft));
  const std::string key = nameOf(bindings_.keysOf(Control::kLook).first);
  return key.empty() ? "right mouse button" : "Hold " + key + " and press " + lookWays();
}

std::string KeyHints::lookWays() const {
  const ControlKeys& left = bindings_.keysOf(Control::kLeft);
  const bool arrows = left.first == Key::kArrowLeft || left.second == Key::kArrowLeft;
  return arrows ? "arrows" : sides();
}

std::string KeyHints::goOn() const {
  const std::string button = pad(Control::kVote);
  if (gamepad_ && !button.empty()) return button;
  return bindings_.controlOf(Key::kEnter) ? of(Control::kVote) : "Enter";
}

std::string KeyHints::menu() const { return std::string(shownNameOf(gamepad_ ? Key::kPadStart : Key::kEscape)); }

std::string KeyHints::sides() const { return of(Control::kLeft) + " " + of(Control::kRight); }

std::string KeyHints::run() const {
  const ControlKeys& left = bindings_.keysOf(Control::kLeft);
  const ControlKeys& right = bindings_.keysOf(Control::kRight);
  if (gamepad_ && left.pad && right.pad) return nameOf(left.pad) + " " + nameOf(right.pad);
  const std::string second = left.second && right.second ? nameOf(left.second) + " " + nameOf(right.second) : "";
  return joined(sides(), " or ", second);
}

std::string KeyHints::keys(Control control) const {
  const ControlKeys& keys = bindings_.keysOf(control);
  return joined(nameOf(keys.first), " or ", nameOf(keys.second));
}

std::string KeyHints::pad(Control control) const { return nameOf(bindings_.keysOf(control).pad); }

}  // namespace platon
