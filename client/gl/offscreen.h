#pragma once

namespace platon {

/// An OpenGL 3.3 core context without window and display, by surfaceless EGL. It is current from construction to
/// destruction. Pictures are drawn into a RenderTarget. Equal scenes give equal bytes.
class Offscreen {
 public:
  /// Throws std::runtime_error if the machine has no surfaceless EGL or no OpenGL 3.3.
  Offscreen();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  void* display_;
  void* context_ = nullptr;
};

}  // namespace platon
