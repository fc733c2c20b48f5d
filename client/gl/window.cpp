#include "client/gl/window.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include <GL/glew.h>
#include <GLFW/glfw3.h>

#include "client/ui/overlay.h"

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

namespace {

KeyEvent::Kind kindOf(int glfwAction) {
  if (glfwAction == GLFW_RELEASE) return KeyEvent::Kind::kRelease;
  return glfwAction == GLFW_REPEAT ? KeyEvent::Kind::kRepeat : KeyEvent::Kind::kPress;
}

std::vector<GamepadState> readGamepads() {
  std::vector<GamepadState> gamepads;
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    GLFWgamepadstate state;
    if (glfwJoystickIsGamepad(joystick) != GLFW_TRUE || glfwGetGamepadState(joystick, &state) != GLFW_TRUE) continue;
    gamepads.push_back(gamepadOfGlfw(state));
    gamepads.back().id = joystick;
  }
  return gamepads;
}

std::string textOf(const char* description) { return description != nullptr ? description : "unknown error"; }

GLFWwindow* openWindow(const std::string& title, int width, int height) {
  const char* description = nullptr;
  if (glfwInit() != GLFW_TRUE) {
    glfwGetError(&description);
    throw std::runtime_error("cannot open a window: " + textOf(description));
  }
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  GLFWwindow* handle = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (handle == nullptr) {
    const int code = glfwGetError(&description);
    const std::string error = "cannot open a window: " + textOf(description);
    glfwTerminate();
    if (code == GLFW_API_UNAVAILABLE || code == GLFW_VERSION_UNAVAILABLE) throw NoOpenGl();
    throw std::runtime_error(error);
  }
  return handle;
}

}  // namespace

DesktopWindow::DesktopWindow(const std::string& title, int width, int height)
    : handle_(openWindow(title, width, height)) {
  glfwSetWindowUserPointer(handle_, this);
  glfwSetKeyCallback(handle_, onKey);
  glfwSetCharCallback(handle_, onCharacter);
  glfwSetCursorEnterCallback(handle_, onEnter);
  glfwSetCursorPosCallback(handle_, onMove);
  glfwSetMouseButtonCallback(handle_, onButton);
  glfwSetScrollCallback(handle_, onScroll);
  glfwSetDropCallback(handle_, onDrop);
  glfwSetWindowCloseCallback(handle_, onClose);
  glfwGetCursorPos(handle_, &pointerX_, &pointerY_);
  glfwMakeContextCurrent(handle_);
  glfwSwapInterval(1);
  try {
    loadOpenGl();
  } catch (...) {
    glfwTerminate();
    throw;
  }
  // Until the first picture, the window has the colour of the night sky instead of what was in its memory.
  glClearColor(0.06F, 0.08F, 0.14F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glfwSwapBuffers(handle_);
  poll();
}

DesktopWindow::~DesktopWindow() {
  glfwDestroyWindow(handle_);
  glfwTerminate();
}

void DesktopWindow::poll() {
  glfwPollEvents();
  const std::vector<KeyEvent> gamepadEvents = gamepadKeys_.update(readGamepads());
  events_.insert(events_.end(), gamepadEvents.begin(), gamepadEvents.end());
  for (const int pad : gamepadKeys_.takeLost()) events_.emplace_back(GamepadLost{pad});
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  pixelWidth_ = static_cast<std::uint32_t>(width);
  pixelHeight_ = static_cast<std::uint32_t>(height);
}

bool DesktopWindow::focused() const { return !minimised() && glfwGetWindowAttrib(handle_, GLFW_FOCUSED) == GLFW_TRUE; }

bool DesktopWindow::minimised() const {
  return pixelWidth_ == 0 || pixelHeight_ == 0 || glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) == GLFW_TRUE;
}

std::vector<WindowEvent> DesktopWindow::takeEvents() { return std::exchange(events_, {}); }

std::string DesktopWindow::clipboard() const {
  const char* const text = glfwGetClipboardString(handle_);
  return text == nullptr ? std::string() : std::string(text);
}

void DesktopWindow::setVsync(bool vsync) {
  if (vsync == vsync_) return;
  vsync_ = vsync;
  glfwSwapInterval(vsync ? 1 : 0);
}

void DesktopWindow::setTitle(const std::string& title) { glfwSetWindowTitle(handle_, title.c_str()); }

void DesktopWindow::setFullscreen(bool fullscreen) {
  const bool isFullscreen = glfwGetWindowMonitor(handle_) != nullptr;
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (fullscreen == isFullscreen || monitor == nullptr) return;
  if (fullscreen) {
    glfwGetWindowPos(handle_, &windowed_[0], &windowed_[1]);
    glfwGetWindowSize(handle_, &windowed_[2], &windowed_[3]);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else {
    glfwSetWindowMonitor(handle_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], GLFW_DONT_CARE);
  }
  glfwSwapInterval(vsync_ ? 1 : 0);
}

void DesktopWindow::show() { glfwSwapBuffers(handle_); }

void DesktopWindow::onKey(GLFWwindow* handle, int key, int /*scancode*/, int action, int mods) {
  const std::optional<Key> known = keyOfGlfw(key);
  if (!known) return;
  auto& window = *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle));
  window.events_.push_back(KeyEvent{*known, kindOf(action), (mods & GLFW_MOD_ALT) != 0, (mods & GLFW_MOD_CONTROL) != 0,
                                    (mods & GLFW_MOD_SHIFT) != 0});
}

void DesktopWindow::onCharacter(GLFWwindow* handle, unsigned codePoint) {
  KeyEvent event;
  event.kind = KeyEvent::Kind::kCharacter;
  event.character = codePoint;
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))->events_.push_back(event);
}

void DesktopWindow::onEnter(GLFWwindow* handle, int entered) {
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))->entered_ = entered == GLFW_TRUE;
}

// The window may have moved below the pointer: only the next place tells that the pointer moves.
void DesktopWindow::onMove(GLFWwindow* handle, double x, double y) {
  auto& window = *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle));
  window.pointerX_ = x;
  window.pointerY_ = y;
  if (!std::exchange(window.entered_, false)) window.addPointerEvent(PointerEvent());
}

void DesktopWindow::onButton(GLFWwindow* handle, int button, int action, int /*mods*/) {
  if (button > GLFW_MOUSE_BUTTON_4) return;  // the one that goes back
  PointerEvent event;
  event.kind = action == GLFW_PRESS ? PointerEvent::Kind::kPress : PointerEvent::Kind::kRelease;
  event.button = static_cast<PointerEvent::Button>(button);
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))->addPointerEvent(event);
}

void DesktopWindow::onDrop(GLFWwindow* handle, int count, const char** paths) {
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))
      ->events_.emplace_back(FilesDropped{std::vector<std::string>(paths, paths + count)});
}

void DesktopWindow::onClose(GLFWwindow* handle) {
  glfwSetWindowShouldClose(handle, GLFW_FALSE);
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))->events_.emplace_back(CloseAsked());
}

void DesktopWindow::onScroll(GLFWwindow* handle, double /*x*/, double y) {
  PointerEvent event;
  event.kind = PointerEvent::Kind::kScroll;
  event.scroll = y;
  static_cast<DesktopWindow*>(glfwGetWindowUserPointer(handle))->addPointerEvent(event);
}

// Adds the place and the keys that are held.
void DesktopWindow::addPointerEvent(PointerEvent event) {
  int width = 0;
  int height = 0;
  glfwGetWindowSize(handle_, &width, &height);
  event.place = glm::dvec2(pointerX_, pointerY_) * (double{Overlay::kHeight} / std::max(height, 1));
  const auto held = [this](int left, int right) {
    return glfwGetKey(handle_, left) == GLFW_PRESS || glfwGetKey(handle_, right) == GLFW_PRESS;
  };
  event.alt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  event.shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  events_.push_back(event);
}

}  // namespace platon
