#pragma once

#include <stdexcept>
#include <string>

namespace platon {

/// The graphics driver has no OpenGL 3.3, with or without a window; the text says what can be done.
struct NoOpenGl : std::runtime_error {
  NoOpenGl()
      : std::runtime_error("the graphics driver has no OpenGL 3.3: update it, or start with LIBGL_ALWAYS_SOFTWARE=1") {}
};

/// Loads the functions of the current OpenGL context. Throws NoOpenGl below OpenGL 3.3, and std::runtime_error if they
/// cannot be loaded.
void loadOpenGl();

/// Returns and clears the recorded OpenGL errors as text; empty if there are none.
std::string takeGlErrors();

/// What the driver of the current context calls itself: GL_RENDERER.
std::string driverName();

/// Waits until everything is drawn.
void finishDrawing();

/// An OpenGL 3.3 core context without window and display, by surfaceless EGL. It is current from construction to
/// destruction. Pictures are drawn into a RenderTarget. Equal scenes give equal bytes.
class Offscreen {
 public:
  /// Throws NoOpenGl if the driver has no OpenGL 3.3, and std::runtime_error if the machine has no surfaceless EGL.
  Offscreen();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  void* display_;
  void* context_ = nullptr;
};

}  // namespace platon
