#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/ui/steering.h"

struct GLFWwindow;

namespace platon {

/// A window with an OpenGL 3.3 core context, current from construction to destruction; keyboard and gamepad. One at a
/// time, on the main thread.
class Window {
 public:
  /// What was pressed, besides what is held.
  enum class Press : std::uint8_t { kMenu, kUp, kDown, kLeft, kRight, kChoose, kHelp, kNetGraph, kFullscreen };

  /// `width` × `height` in screen coordinates. Throws std::runtime_error when there is no display or no such OpenGL.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Takes in what happened since the last call.
  void poll();
  bool closing() const;
  /// Since the last call, in order.
  std::vector<Press> takePresses();
  /// Held on the keyboard or any gamepad as of the last `poll`.
  const HeldKeys& held() const { return held_; }

  /// Of the picture, in pixels; 0 while minimised.
  std::uint32_t pixelWidth() const { return pixelWidth_; }
  std::uint32_t pixelHeight() const { return pixelHeight_; }

  void setFullscreen(bool fullscreen);
  /// Shows what has been drawn; waits for the screen.
  void show();

 private:
  struct Buttons {
    bool menu = false, choose = false, up = false, down = false, left = false, right = false;
  };

  static void onKey(GLFWwindow* handle, int key, int scancode, int action, int mods);
  void pollGamepads();
  void press(bool now, bool before, Press what);

  GLFWwindow* handle_ = nullptr;
  HeldKeys held_;
  Buttons gamepad_;  // as of the last poll, to see what is new
  std::vector<Press> presses_;
  std::uint32_t pixelWidth_ = 0;
  std::uint32_t pixelHeight_ = 0;
  int windowed_[4] = {0, 0, 1280, 720};  // place and size to go back to from full screen
};

}  // namespace platon
