#include "client/gl/draw_calls.h"

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

}  // namespace platon
