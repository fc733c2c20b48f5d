#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/ui/controls/gamepad_keys.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"

struct GLFWgamepadstate;
struct GLFWwindow;

namespace platon {

/// The key that GLFW names `glfwKey`; nothing if the client does not use it.
std::optional<Key> keyOfGlfw(int glfwKey);

/// The state of a gamepad as GLFW reports it. A trigger is pressed from half its way.
GamepadState gamepadOfGlfw(const GLFWgamepadstate& glfwState);

/// The gamepad that was used last has been disconnected. The events that release its keys come before.
struct GamepadLost {};

/// Files were dropped on the window; their paths, in order.
struct FilesDropped {
  std::vector<std::string> paths;
};

/// The player has asked to close the window, which stays open.
struct CloseAsked {};

using WindowEvent = std::variant<KeyEvent, PointerEvent, GamepadLost, FilesDropped, CloseAsked>;

/// A window with an OpenGL 3.3 core context, which is current from construction to destruction, and the source of the
/// events of keyboard, gamepads, mouse and window manager. At most one exists at a time, on the main thread.
class Window {
 public:
  /// `width` × `height` in screen coordinates. Throws NoOpenGl if the driver has no OpenGL 3.3, and
  /// std::runtime_error if there is no display.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Processes the events since the last call.
  void poll();
  /// Whether the keys go to this window; not while it is minimised.
  bool focused() const;
  /// Whether nothing of the window is shown; also if its size is 0.
  bool minimised() const;
  /// Returns the events since the last call in the order in which they happened; those of the gamepads as of each
  /// `poll`. Characters that are typed follow their keys. A window that loses the focus releases all keys; one that
  /// comes to lie below a pointer at rest gets no kMove.
  std::vector<WindowEvent> takeEvents();
  /// The text of the clipboard, UTF-8; empty if it has none.
  std::string clipboard() const;
  /// Shows this text in the title bar.
  void setTitle(const std::string& title);

  /// Size of the picture in pixels. While the window is minimised, it may be 0 or what it was before.
  std::uint32_t pixelWidth() const { return pixelWidth_; }
  std::uint32_t pixelHeight() const { return pixelHeight_; }

  /// Covers the primary monitor, or restores the previous position and size. No effect if already in that state.
  void setFullscreen(bool fullscreen);
  /// Whether `show` waits for the vertical blank of the screen; it does at first.
  void setVsync(bool vsync);
  /// Shows what has been drawn.
  void show();

 private:
  static void onKey(GLFWwindow* handle, int key, int scancode, int action, int mods);
  static void onCharacter(GLFWwindow* handle, unsigned codePoint);
  static void onEnter(GLFWwindow* handle, int entered);
  static void onMove(GLFWwindow* handle, double x, double y);
  static void onButton(GLFWwindow* handle, int button, int action, int mods);
  static void onScroll(GLFWwindow* handle, double x, double y);
  static void onDrop(GLFWwindow* handle, int count, const char** paths);
  static void onClose(GLFWwindow* handle);
  void addPointerEvent(PointerEvent event);

  GLFWwindow* handle_ = nullptr;
  std::vector<WindowEvent> events_;
  double pointerX_ = 0;  // as of the last event, in screen coordinates
  double pointerY_ = 0;
  bool entered_ = false;  // the pointer is new in the window, and its place is not known yet
  GamepadKeys gamepadKeys_;
  bool vsync_ = true;
  std::uint32_t pixelWidth_ = 0;
  std::uint32_t pixelHeight_ = 0;
  int windowed_[4] = {0, 0, 1280, 720};  // position and size before full screen
};

}  // namespace platon
