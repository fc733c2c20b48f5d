#include "client/gl/glfw_keys.h"

#include <algorithm>
#include <array>
#include <utility>

#include <GLFW/glfw3.h>

namespace platon {
namespace {

constexpr std::array kKeys{std::pair{GLFW_KEY_LEFT, Key::kArrowLeft},
                           std::pair{GLFW_KEY_RIGHT, Key::kArrowRight},
                           std::pair{GLFW_KEY_UP, Key::kArrowUp},
                           std::pair{GLFW_KEY_DOWN, Key::kArrowDown},
                           std::pair{GLFW_KEY_SPACE, Key::kSpace},
                           std::pair{GLFW_KEY_ENTER, Key::kEnter},
                           std::pair{GLFW_KEY_KP_ENTER, Key::kEnter},
                           std::pair{GLFW_KEY_LEFT_SHIFT, Key::kShift},
                           std::pair{GLFW_KEY_RIGHT_SHIFT, Key::kShift},
                           std::pair{GLFW_KEY_LEFT_CONTROL, Key::kControl},
                           std::pair{GLFW_KEY_RIGHT_CONTROL, Key::kControl},
                           std::pair{GLFW_KEY_LEFT_ALT, Key::kAlt},
                           std::pair{GLFW_KEY_RIGHT_ALT, Key::kAlt},
                           std::pair{GLFW_KEY_TAB, Key::kTab},
                           std::pair{GLFW_KEY_ESCAPE, Key::kEscape},
                           std::pair{GLFW_KEY_KP_ADD, Key::kPlus},
                           std::pair{GLFW_KEY_EQUAL, Key::kPlus},
                           std::pair{GLFW_KEY_KP_SUBTRACT, Key::kMinus},
                           std::pair{GLFW_KEY_MINUS, Key::kMinus},
                           std::pair{GLFW_KEY_DELETE, Key::kDelete},
                           std::pair{GLFW_KEY_BACKSPACE, Key::kBackspace},
                           std::pair{GLFW_KEY_PAGE_UP, Key::kPageUp},
                           std::pair{GLFW_KEY_PAGE_DOWN, Key::kPageDown},
                           std::pair{GLFW_KEY_HOME, Key::kHome},
                           std::pair{GLFW_KEY_END, Key::kEnd},
                           std::pair{GLFW_KEY_INSERT, Key::kInsert},
                           std::pair{GLFW_KEY_COMMA, Key::kComma},
                           std::pair{GLFW_KEY_PERIOD, Key::kPeriod},
                           std::pair{GLFW_KEY_SLASH, Key::kSlash},
                           std::pair{GLFW_KEY_SEMICOLON, Key::kSemicolon},
                           std::pair{GLFW_KEY_APOSTROPHE, Key::kApostrophe},
                           std::pair{GLFW_KEY_LEFT_BRACKET, Key::kLeftBracket},
                           std::pair{GLFW_KEY_RIGHT_BRACKET, Key::kRightBracket},
                           std::pair{GLFW_KEY_BACKSLASH, Key::kBackslash},
                           std::pair{GLFW_KEY_GRAVE_ACCENT, Key::kGrave}};

// From A to Z, as GLFW has them.
constexpr std::array kLetters{Key::kA, Key::kB, Key::kC, Key::kD, Key::kE, Key::kF, Key::kG, Key::kH, Key::kI,
                              Key::kJ, Key::kK, Key::kL, Key::kM, Key::kN, Key::kO, Key::kP, Key::kQ, Key::kR,
                              Key::kS, Key::kT, Key::kU, Key::kV, Key::kW, Key::kX, Key::kY, Key::kZ};

Key after(Key first, int steps) { return static_cast<Key>(static_cast<int>(first) + steps); }

}  // namespace

std::optional<Key> keyOfGlfw(int glfwKey) {
  if (glfwKey >= GLFW_KEY_A && glfwKey <= GLFW_KEY_Z)
    return kLetters.at(static_cast<std::size_t>(glfwKey - GLFW_KEY_A));
  if (glfwKey >= GLFW_KEY_0 && glfwKey <= GLFW_KEY_9) return after(Key::kDigit0, glfwKey - GLFW_KEY_0);
  if (glfwKey >= GLFW_KEY_F1 && glfwKey <= GLFW_KEY_F12) return after(Key::kF1, glfwKey - GLFW_KEY_F1);
  if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9) return after(Key::kKeypad0, glfwKey - GLFW_KEY_KP_0);
  const auto found = std::find_if(kKeys.begin(), kKeys.end(), [&](const auto& pair) { return pair.first == glfwKey; });
  return found == kKeys.end() ? std::nullopt : std::optional(found->second);
}

GamepadState gamepadOfGlfw(const GLFWgamepadstate& glfwState) {
  const auto down = [&glfwState](int button) { return glfwState.buttons[button] == GLFW_PRESS; };
  GamepadState state;
  state.stickX = glfwState.axes[GLFW_GAMEPAD_AXIS_LEFT_X];
  state.stickY = glfwState.axes[GLFW_GAMEPAD_AXIS_LEFT_Y];
  state.lookX = glfwState.axes[GLFW_GAMEPAD_AXIS_RIGHT_X];
  state.lookY = glfwState.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y];
  state.dpadLeft = down(GLFW_GAMEPAD_BUTTON_DPAD_LEFT);
  state.dpadRight = down(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT);
  state.dpadUp = down(GLFW_GAMEPAD_BUTTON_DPAD_UP);
  state.dpadDown = down(GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
  state.a = down(GLFW_GAMEPAD_BUTTON_A);
  state.b = down(GLFW_GAMEPAD_BUTTON_B);
  state.x = down(GLFW_GAMEPAD_BUTTON_X);
  state.y = down(GLFW_GAMEPAD_BUTTON_Y);
  state.start = down(GLFW_GAMEPAD_BUTTON_START);
  state.back = down(GLFW_GAMEPAD_BUTTON_BACK);
  state.leftBumper = down(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER);
  state.rightBumper = down(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER);
  state.leftStick = down(GLFW_GAMEPAD_BUTTON_LEFT_THUMB);
  state.rightStick = down(GLFW_GAMEPAD_BUTTON_RIGHT_THUMB);
  state.leftTrigger = glfwState.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] > 0;
  state.rightTrigger = glfwState.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] > 0;
  return state;
}

}  // namespace platon
