#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gl/gl_context.h"
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

/// A gamepad with which somebody has played has been disconnected. The events that release its keys come before.
struct GamepadLost {
  int pad = 0;  ///< GamepadState::id
};

/// Files were dropped on the window; their paths, in order.
struct FilesDropped {
  std::vector<std::string> paths;
};

/// The player has asked to close the window, which stays open.
struct CloseAsked {};

using WindowEvent = std::variant<KeyEvent, PointerEvent, GamepadLost, FilesDropped, CloseAsked>;

/// Where the program shows its pictures, with an OpenGL 3.3 core context, which is current from construction to
/// destruction, and the source of the events of keyboard, gamepads, mouse and window manager. At most one exists at a
/// time, on the main thread.
class Window {
 public:
  virtual ~Window() = default;

  /// Processes the events since the last call.
  virtual void poll() = 0;
  /// Whether the keys go to this window; not while it is minimised.
  virtual bool focused() const = 0;
  /// Whether nothing of the window is shown; also if its size is 0.
  virtual bool minimised() const = 0;
  /// Returns the events since the last call in the order in which they happened; those of the gamepads as of each
  /// `poll`. Characters that are typed follow their keys. A window that loses the focus releases all keys; one that
  /// comes to lie below a pointer at rest gets no kMove.
  virtual std::vector<WindowEvent> takeEvents() = 0;
  /// The text of the clipboard, UTF-8; empty if it has none.
  virtual std::string clipboard() const = 0;
  /// Shows this text in the title bar.
  virtual void setTitle(const std::string& title) = 0;

  /// Size of the picture in pixels. While the window is minimised, it may be 0 or what it was before.
  virtual std::uint32_t pixelWidth() const = 0;
  virtual std::uint32_t pixelHeight() const = 0;

  /// Covers the primary monitor, or restores the previous position and size. No effect if already in that state.
  virtual void setFullscreen(bool fullscreen) = 0;
  /// Whether `show` waits for the vertical blank of the screen; it does at first.
  virtual void setVsync(bool vsync) = 0;
  /// Whether it has a framebuffer of its own, to which pictures are copied before `show`.
  virtual bool onScreen() const = 0;
  /// Shows what has been drawn.
  virtual void show() = 0;
};

/// A window on the desktop, by GLFW.
class DesktopWindow : public Window {
 public:
  /// `width` × `height` in screen coordinates. Throws NoOpenGl if the driver has no OpenGL 3.3, and
  /// std::runtime_error if there is no display.
  DesktopWindow(const std::string& title, int width, int height);
  ~DesktopWindow() override;
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;

  void poll() override;
  bool focused() const override;
  bool minimised() const override;
  std::vector<WindowEvent> takeEvents() override;
  std::string clipboard() const override;
  void setTitle(const std::string& title) override;
  std::uint32_t pixelWidth() const override { return pixelWidth_; }
  std::uint32_t pixelHeight() const override { return pixelHeight_; }
  void setFullscreen(bool fullscreen) override;
  void setVsync(bool vsync) override;
  bool onScreen() const override { return true; }
  void show() override;

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

/// A window without a display. It always has the focus, and no events come from it.
class OffscreenWindow : public Window {
 public:
  /// `width` × `height` in pixels. Throws as Offscreen.
  OffscreenWindow(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {}

  void poll() override {}
  bool focused() const override { return true; }
  bool minimised() const override { return false; }
  std::vector<WindowEvent> takeEvents() override { return {}; }
  std::string clipboard() const override { return {}; }
  void setTitle(const std::string& /*title*/) override {}
  std::uint32_t pixelWidth() const override { return width_; }
  std::uint32_t pixelHeight() const override { return height_; }
  void setFullscreen(bool /*fullscreen*/) override {}
  void setVsync(bool /*vsync*/) override {}
  bool onScreen() const override { return false; }
  void show() override {}

 private:
  Offscreen context_;
  std::uint32_t width_;
  std::uint32_t height_;
};

}  // namespace platon
