#pragma once

namespace platon {

/// An OpenGL 3.3 core context without a window or display, by surfaceless EGL; current from construction to
/// destruction. Pictures are drawn into a RenderTarget. The same scene gives the same bytes.
class Offscreen {
 public:
  /// Throws std::runtime_error when the machine has no such OpenGL.
  Offscreen();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  void* display_;
  void* context_ = nullptr;
};

}  // namespace platon
