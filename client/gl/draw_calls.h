#pragma once

#include <cstdint>

#include <GL/glew.h>

namespace platon {

/// The draw calls of the current context. All of them are issued here, so that a benchmark can count them, and can
/// withhold them to measure the rest of a frame without the work of the driver. As OpenGL itself, for one thread.
class DrawCalls {
 public:
  /// As the functions of OpenGL. `offset` is in bytes.
  static void arrays(GLenum mode, GLsizei count, GLint first = 0);
  static void arraysInstanced(GLenum mode, GLsizei count, GLsizei instances);
  static void elements(GLenum mode, GLsizei count, GLenum type, const void* offset);
  /// As glClear and glBlitFramebuffer from the lower left corner, of colours; neither is a draw call.
  static void clear(GLbitfield buffers);
  static void blit(GLint fromWidth, GLint fromHeight, GLint toWidth, GLint toHeight, GLenum filter);

  /// The draw calls so far.
  static std::uint64_t count() { return count_; }
  /// While on, calls are counted, but do not reach the driver.
  static void withhold(bool on) { withheld_ = on; }

 private:
  static inline std::uint64_t count_ = 0;
  static inline bool withheld_ = false;
};

}  // namespace platon
