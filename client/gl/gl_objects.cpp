#include "client/gl/gl_objects.h"

namespace platon {

void DrawCalls::arrays(GLenum mode, GLsizei count, GLint first) {
  ++count_;
  if (!withheld_) glDrawArrays(mode, first, count);
}

void DrawCalls::arraysInstanced(GLenum mode, GLsizei count, GLsizei instances) {
  ++count_;
  if (!withheld_) glDrawArraysInstanced(mode, 0, count, instances);
}

void DrawCalls::elements(GLenum mode, GLsizei count, GLenum type, const void* offset) {
  ++count_;
  if (!withheld_) glDrawElements(mode, count, type, offset);
}

void DrawCalls::clear(GLbitfield buffers) {
  if (!withheld_) glClear(buffers);
}

void DrawCalls::blit(GLint fromWidth, GLint fromHeight, GLint toWidth, GLint toHeight, GLenum filter) {
  if (withheld_) return;
  glBlitFramebuffer(0, 0, fromWidth, fromHeight, 0, 0, toWidth, toHeight, GL_COLOR_BUFFER_BIT, filter);
}

void DrawCalls::copy(glm::ivec2 size, glm::ivec2 to) {
  if (withheld_) return;
  glBlitFramebuffer(0, 0, size.x, size.y, to.x, to.y, to.x + size.x, to.y + size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void attachColour(const GlTexture& texture, std::uint32_t width, std::uint32_t height) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  // The order of the bytes in windows, which drivers that draw with the processor copy and write fastest.
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0, GL_BGRA,
               GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
}

}  // namespace platon
