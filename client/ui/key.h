#pragma once

#include <cstddef>
#include <cstdint>

namespace platon {

/// The keys and gamepad buttons that the client uses.
enum class Key : std::uint8_t {
  kArrowLeft,
  kArrowRight,
  kArrowUp,
  kArrowDown,
  kA,
  kD,
  kW,
  kS,
  kSpace,
  kEnter,
  kR,
  kV,
  kShift,
  kTab,
  kEscape,
  kF1,  ///< the function keys are in order
  kF2,
  kF3,
  kF4,
  kF5,
  kF6,
  kF7,
  kF8,
  kF9,
  kF10,
  kF11,
  kF12,
  kC,
  kE,
  kF,
  kG,
  kH,
  kP,
  kT,
  kX,
  kY,
  kZ,
  kB,
  kI,
  kJ,
  kK,
  kL,
  kM,
  kN,
  kO,
  kQ,
  kU,
  kDigit0,  ///< the digits are in order
  kDigit1,
  kDigit2,
  kDigit3,
  kDigit4,
  kDigit5,
  kDigit6,
  kDigit7,
  kDigit8,
  kDigit9,
  kPlus,
  kMinus,
  kDelete,
  kBackspace,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kInsert,
  kControl,
  kAlt,
  kComma,
  kPeriod,
  kSlash,
  kSemicolon,
  kApostrophe,
  kLeftBracket,
  kRightBracket,
  kBackslash,
  kGrave,
  kKeypad0,  ///< the digits of the keypad are in order
  kKeypad1,
  kKeypad2,
  kKeypad3,
  kKeypad4,
  kKeypad5,
  kKeypad6,
  kKeypad7,
  kKeypad8,
  kKeypad9,
  kPadLeft,  ///< D-pad or left stick, as the next three
  kPadRight,
  kPadUp,
  kPadDown,
  kPadWalk,      ///< left stick between kPadCreep and its full deflection
  kPadCreep,     ///< left stick a little to the left or right
  kPadLookLeft,  ///< right stick, as the next three
  kPadLookRight,
  kPadLookUp,
  kPadLookDown,
  kPadA,
  kPadB,
  kPadStart,
  kPadBack,
  kPadX,
  kPadY,
  kPadLeftBumper,
  kPadRightBumper,
  kPadLeftTrigger,
  kPadRightTrigger,
  kPadLeftStick,  ///< pressed, as the next one
  kPadRightStick
};
inline constexpr std::size_t kKeyCount = static_cast<std::size_t>(Key::kPadRightStick) + 1;

/// Whether the key belongs to a gamepad.
constexpr bool isOfGamepad(Key key) { return key >= Key::kPadLeft; }

/// A change of one key, or a character that was typed.
struct KeyEvent {
  enum class Kind : std::uint8_t { kPress, kRepeat, kRelease, kCharacter };

  Key key = Key::kSpace;  ///< means nothing of a kCharacter
  Kind kind = Kind::kPress;
  bool alt = false;        ///< Alt was held
  bool ctrl = false;       ///< Ctrl was held
  bool shift = false;      ///< Shift was held
  char32_t character = 0;  ///< of a kCharacter: its code point
  int pad = 0;             ///< of a key of a gamepad: GamepadState::id

  friend bool operator==(const KeyEvent&, const KeyEvent&) = default;
};

}  // namespace platon
