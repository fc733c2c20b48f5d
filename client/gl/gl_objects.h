#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <GL/glew.h>
#include <glm/vec2.hpp>

namespace platon {

/// Owns one OpenGL object, which the functions of OpenGL `Create` and `Delete` create and delete. The context must be
/// current when it is destroyed.
template <auto& Create, auto& Delete>
class GlHandle {
 public:
  GlHandle() { Create(1, &name_); }
  ~GlHandle() { reset(); }
  GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    if (this != &other) {
      reset();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  GlHandle(const GlHandle&) = delete;
  GlHandle& operator=(const GlHandle&) = delete;

  GLuint name() const { return name_; }

 private:
  void reset() {
    if (name_ != 0) Delete(1, &name_);
  }

  GLuint name_ = 0;
};

/// Byte offset into the bound buffer, in the form that OpenGL expects.
inline const void* bufferOffset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): never dereferenced
}

using GlBuffer = GlHandle<glGenBuffers, glDeleteBuffers>;
using GlVertexArray = GlHandle<glGenVertexArrays, glDeleteVertexArrays>;
using GlTexture = GlHandle<glGenTextures, glDeleteTextures>;
using GlRenderbuffer = GlHandle<glGenRenderbuffers, glDeleteRenderbuffers>;
using GlFramebuffer = GlHandle<glGenFramebuffers, glDeleteFramebuffers>;

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
  /// Likewise, with its lower left corner at `to`.
  static void copy(glm::ivec2 size, glm::ivec2 to);

  /// The draw calls so far.
  static std::uint64_t count() { return count_; }
  /// While on, calls are counted, but do not reach the driver.
  static void withhold(bool on) { withheld_ = on; }

 private:
  static inline std::uint64_t count_ = 0;
  static inline bool withheld_ = false;
};

/// A vertex array whose vertices are replaced before each draw call. `Vertex` is a struct of floats.
template <class Vertex>
class VertexStream {
 public:
  /// Reads `size` floats at `offset` of each vertex as the shader's attribute `index`.
  void attribute(GLuint index, GLint size, std::size_t offset) {
    bind();
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), bufferOffset(offset));
  }

  /// Draws triangles of three vertices each with the current program.
  void drawTriangles(const std::vector<Vertex>& vertices) {
    bind();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STREAM_DRAW);
    DrawCalls::arrays(GL_TRIANGLES, static_cast<GLsizei>(vertices.size()));
  }

 private:
  void bind() const {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  }

  GlVertexArray array_;
  GlBuffer buffer_;
};

/// Makes `texture` a picture of this size in pixels, and what is drawn to the bound framebuffer. Between pixels it is
/// interpolated linearly.
void attachColour(const GlTexture& texture, std::uint32_t width, std::uint32_t height);

}  // namespace platon
