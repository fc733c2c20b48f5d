#pragma once

namespace platon {

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
