#pragma once

#include <cstddef>
#include <utility>

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

}  // namespace platon
