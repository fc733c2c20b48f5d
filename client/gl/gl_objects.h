#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <GL/glew.h>

namespace platon {

/// Owns one OpenGL object, which `Create` and `Delete` create and delete. The context must be current when it is
/// destroyed.
template <GLuint (*Create)(), void (*Delete)(GLuint)>
class GlHandle {
 public:
  GlHandle() : name_(Create()) {}
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
    if (name_ != 0) Delete(name_);
  }

  GLuint name_;
};

namespace intern {

inline GLuint createBuffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return name;
}
inline void deleteBuffer(GLuint name) { glDeleteBuffers(1, &name); }

inline GLuint createVertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return name;
}
inline void deleteVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }

inline GLuint createTexture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}
inline void deleteTexture(GLuint name) { glDeleteTextures(1, &name); }

inline GLuint createRenderbuffer() {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  return name;
}
inline void deleteRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }

inline GLuint createFramebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return name;
}
inline void deleteFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }

}  // namespace intern

/// Byte offset into the bound buffer, in the form that OpenGL expects.
inline const void* bufferOffset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): never dereferenced
}

using GlBuffer = GlHandle<intern::createBuffer, intern::deleteBuffer>;
using GlVertexArray = GlHandle<intern::createVertexArray, intern::deleteVertexArray>;
using GlTexture = GlHandle<intern::createTexture, intern::deleteTexture>;
using GlRenderbuffer = GlHandle<intern::createRenderbuffer, intern::deleteRenderbuffer>;
using GlFramebuffer = GlHandle<intern::createFramebuffer, intern::deleteFramebuffer>;

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
