#include "client/gl/render_target.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace platon {
namespace {

void attach(GLenum slot, const GlRenderbuffer& buffer, GLenum format, GLsizei samples, GLsizei width, GLsizei height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer.name());
}

void requireComplete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the graphics driver does not support pictures of this size");
  }
}

}  // namespace

RenderTarget::RenderTarget(std::uint32_t width, std::uint32_t height, int samples) : width_(width), height_(height) {
  GLint maxSamples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &maxSamples);
  const GLsizei used = std::min(samples, maxSamples);
  const auto w = static_cast<GLsizei>(width);
  const auto h = static_cast<GLsizei>(height);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  attach(GL_COLOR_ATTACHMENT0, sampledColour_, GL_RGBA8, used, w, h);
  attach(GL_DEPTH_ATTACHMENT, sampledDepth_, GL_DEPTH_COMPONENT24, used, w, h);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  attach(GL_COLOR_ATTACHMENT0, plainColour_, GL_RGBA8, 0, w, h);
  requireComplete();
}

void RenderTarget::bindSampled() const {
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

void RenderTarget::resolve() const {
  const auto w = static_cast<GLint>(width_);
  const auto h = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.name());
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
}

void RenderTarget::present() const {
  const auto w = static_cast<GLint>(width_);
  const auto h = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image RenderTarget::read() const {
  Image image{width_, height_, std::vector<std::uint8_t>(std::size_t{3} * width_ * height_)};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGB, GL_UNSIGNED_BYTE,
               image.pixels.data());
  flipRows(image);
  return image;
}

}  // namespace platon
