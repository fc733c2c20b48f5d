#include "client/gl/render_target.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "client/gl/draw_calls.h"

namespace platon {
namespace {

void attach(GLenum slot, const GlRenderbuffer& buffer, GLenum format, GLsizei samples, GLsizei width, GLsizei height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer.name());
}

std::uint32_t scaled(std::uint32_t size, double scale) {
  return std::max(1U, static_cast<std::uint32_t>(std::lround(scale * size)));
}

void requireComplete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the graphics driver does not support pictures of this size");
  }
}

}  // namespace

RenderTarget::RenderTarget(std::uint32_t width, std::uint32_t height, int samples, double scale)
    : width_(width), height_(height), sampledWidth_(scaled(width, scale)), sampledHeight_(scaled(height, scale)) {
  GLint maxSamples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &maxSamples);
  // One sample is asked for as 0: some drivers round 1 up.
  const GLsizei used = samples > 1 ? std::min(samples, maxSamples) : 0;
  const auto w = static_cast<GLsizei>(sampledWidth_);
  const auto h = static_cast<GLsizei>(sampledHeight_);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  attach(GL_COLOR_ATTACHMENT0, sampledColour_, GL_RGBA8, used, w, h);
  attach(GL_DEPTH_ATTACHMENT, sampledDepth_, GL_DEPTH_COMPONENT24, used, w, h);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, small_.name());
  attach(GL_COLOR_ATTACHMENT0, smallColour_, GL_RGBA8, 0, w, h);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  attach(GL_COLOR_ATTACHMENT0, plainColour_, GL_RGBA8, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
  requireComplete();
}

void RenderTarget::bindSampled() const {
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  glViewport(0, 0, static_cast<GLsizei>(sampledWidth_), static_cast<GLsizei>(sampledHeight_));
}

// A multisampled picture must be resolved at its own size before it is scaled.
void RenderTarget::resolve() const {
  const auto w = static_cast<GLint>(sampledWidth_);
  const auto h = static_cast<GLint>(sampledHeight_);
  const bool scaling = sampledWidth_ != width_ || sampledHeight_ != height_;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, scaling ? small_.name() : plain_.name());
  DrawCalls::blit(w, h, w, h, GL_NEAREST);
  if (scaling) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, small_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.name());
    DrawCalls::blit(w, h, static_cast<GLint>(width_), static_cast<GLint>(height_), GL_LINEAR);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

void RenderTarget::present() const {
  const auto w = static_cast<GLint>(width_);
  const auto h = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  DrawCalls::blit(w, h, w, h, GL_NEAREST);
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
