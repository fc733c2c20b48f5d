#include "client/gl/render_target.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"

namespace platon {

PictureScaler::PictureScaler() : program_("picture") {}

void PictureScaler::draw(const GlTexture& picture) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture.name());
  program_.use();
  program_.set("picture", 0);
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  glEnable(GL_BLEND);
}

namespace {

std::uint32_t scaled(std::uint32_t size, double scale) {
  return std::max(1U, static_cast<std::uint32_t>(std::lround(scale * size)));
}

// One sample is asked for as 0: some drivers round 1 up.
GLsizei supported(int samples) {
  GLint max = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &max);
  return samples > 1 ? std::min(samples, max) : 0;
}

void requireComplete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the graphics driver does not support pictures of this size");
  }
}

}  // namespace

RenderTarget::RenderTarget(std::uint32_t width, std::uint32_t height, int samples, double scale)
    : width_(width),
      height_(height),
      sampledWidth_(scaled(width, scale)),
      sampledHeight_(scaled(height, scale)),
      samples_(supported(samples)),
      scaler_(sampledWidth_ == width && sampledHeight_ == height ? nullptr : std::make_unique<PictureScaler>()) {
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  attachColour(plainColour_, width, height);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, small_.name());
  if (scaler_) attachColour(smallColour_, sampledWidth_, sampledHeight_);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn().name());
  if (samples_ > 0) attachSampled(GL_COLOR_ATTACHMENT0, sampledColour_, GL_RGBA8);
  attachSampled(GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT24);
  requireComplete();
}

void RenderTarget::attachSampled(GLenum slot, const GlRenderbuffer& buffer, GLenum format) const {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, format, static_cast<GLsizei>(sampledWidth_),
                                   static_cast<GLsizei>(sampledHeight_));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer.name());
}

void RenderTarget::bindSampled() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn().name());
  glViewport(0, 0, static_cast<GLsizei>(sampledWidth_), static_cast<GLsizei>(sampledHeight_));
}

// A multisampled picture must be resolved at its own size before it is scaled.
void RenderTarget::resolve() const {
  const auto w = static_cast<GLint>(sampledWidth_);
  const auto h = static_cast<GLint>(sampledHeight_);
  if (samples_ > 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, scaler_ ? small_.name() : plain_.name());
    DrawCalls::blit(w, h, w, h, GL_NEAREST);
  }
  bindPlain();
  if (scaler_) scaler_->draw(smallColour_);
}

void RenderTarget::bindPlain() const {
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

void RenderTarget::clearPlain() const {
  bindPlain();
  glClearColor(0, 0, 0, 1);
  DrawCalls::clear(GL_COLOR_BUFFER_BIT);
}

void RenderTarget::copyInto(const RenderTarget& other, std::uint32_t x, std::uint32_t y) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.plain_.name());
  DrawCalls::copy({static_cast<GLint>(width_), static_cast<GLint>(height_)},
                  {static_cast<GLint>(x), static_cast<GLint>(y)});
}

void RenderTarget::copyTo(GLuint framebuffer) const {
  const auto w = static_cast<GLint>(width_);
  const auto h = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
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

PictureFade::PictureFade() : program_(shaderText("picture.vert"), shaderText("fade.frag"), "fade") {}

void PictureFade::keep(const RenderTarget& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  attachColour(picture_, target.width(), target.height());
  target.copyTo(framebuffer_);
}

void PictureFade::draw(double opacity) {
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_.name());
  program_.use();
  program_.set("picture", 0);
  program_.set("opacity", static_cast<float>(opacity));
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
}

}  // namespace platon
