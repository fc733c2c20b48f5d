#include "client/gl/window.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <GL/glew.h>
#include <GLFW/glfw3.h>

#include "client/gl/gl_loader.h"
#include "client/gl/glfw_keys.h"
#include "client/ui/overlay.h"

namespace platon {
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

Window::Window(const std::string& title, int width, int height) : handle_(openWindow(title, width, height)) {
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

Window::~Window() {
  glfwDestroyWindow(handle_);
  glfwTerminate();
}

void Window::poll() {
  glfwPollEvents();
  const std::vector<KeyEvent> gamepadEvents = gamepadKeys_.update(readGamepads());
  events_.insert(events_.end(), gamepadEvents.begin(), gamepadEvents.end());
  if (gamepadKeys_.takeLost()) events_.emplace_back(GamepadLost());
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  pixelWidth_ = static_cast<std::uint32_t>(width);
  pixelHeight_ = static_cast<std::uint32_t>(height);
}

bool Window::focused() const { return !minimised() && glfwGetWindowAttrib(handle_, GLFW_FOCUSED) == GLFW_TRUE; }

bool Window::minimised() const {
  return pixelWidth_ == 0 || pixelHeight_ == 0 || glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) == GLFW_TRUE;
}

std::vector<WindowEvent> Window::takeEvents() { return std::exchange(events_, {}); }

std::string Window::clipboard() const {
  const char* const text = glfwGetClipboardString(handle_);
  return text == nullptr ? std::string() : std::string(text);
}

void Window::setVsync(bool vsync) {
  if (vsync == vsync_) return;
  vsync_ = vsync;
  glfwSwapInterval(vsync ? 1 : 0);
}

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(handle_, title.c_str()); }

void Window::setFullscreen(bool fullscreen) {
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

void Window::show() { glfwSwapBuffers(handle_); }

void Window::onKey(GLFWwindow* handle, int key, int /*scancode*/, int action, int mods) {
  const std::optional<Key> known = keyOfGlfw(key);
  if (!known) return;
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  window.events_.push_back(KeyEvent{*known, kindOf(action), (mods & GLFW_MOD_ALT) != 0, (mods & GLFW_MOD_CONTROL) != 0,
                                    (mods & GLFW_MOD_SHIFT) != 0});
}

void Window::onCharacter(GLFWwindow* handle, unsigned codePoint) {
  KeyEvent event;
  event.kind = KeyEvent::Kind::kCharacter;
  event.character = codePoint;
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->events_.push_back(event);
}

void Window::onEnter(GLFWwindow* handle, int entered) {
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->entered_ = entered == GLFW_TRUE;
}

// The window may have moved below the pointer: only the next place tells that the pointer moves.
void Window::onMove(GLFWwindow* handle, double x, double y) {
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  window.pointerX_ = x;
  window.pointerY_ = y;
  if (!std::exchange(window.entered_, false)) window.addPointerEvent(PointerEvent());
}

void Window::onButton(GLFWwindow* handle, int button, int action, int /*mods*/) {
  if (button > GLFW_MOUSE_BUTTON_4) return;  // the one that goes back
  PointerEvent event;
  event.kind = action == GLFW_PRESS ? PointerEvent::Kind::kPress : PointerEvent::Kind::kRelease;
  event.button = static_cast<PointerEvent::Button>(button);
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->addPointerEvent(event);
}

void Window::onDrop(GLFWwindow* handle, int count, const char** paths) {
  static_cast<Window*>(glfwGetWindowUserPointer(handle))
      ->events_.emplace_back(FilesDropped{std::vector<std::string>(paths, paths + count)});
}

void Window::onClose(GLFWwindow* handle) {
  glfwSetWindowShouldClose(handle, GLFW_FALSE);
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->events_.emplace_back(CloseAsked());
}

void Window::onScroll(GLFWwindow* handle, double /*x*/, double y) {
  PointerEvent event;
  event.kind = PointerEvent::Kind::kScroll;
  event.scroll = y;
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->addPointerEvent(event);
}

// Adds the place and the keys that are held.
void Window::addPointerEvent(PointerEvent event) {
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
