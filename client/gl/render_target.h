#pragma once

#include <cstdint>
#include <memory>

#include "client/gl/gl_handle.h"
#include "client/gl/image.h"
#include "client/gl/picture_scaler.h"

namespace platon {

/// A sampled picture with depth, which may be multisampled and smaller, and the plain picture that it is resolved to.
/// With one sample at full size they are the same.
class RenderTarget {
 public:
  /// `width` × `height` in pixels, at least 1 × 1. `samples` per pixel, limited by the driver. The
  /// sampled picture has `scale` times the size, more than 0. Throws std::runtime_error if the driver does not
  /// support the size.
  RenderTarget(std::uint32_t width, std::uint32_t height, int samples, double scale = 1);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// Size of the sampled picture in pixels.
  std::uint32_t sampledWidth() const { return sampledWidth_; }
  std::uint32_t sampledHeight() const { return sampledHeight_; }

  /// Directs drawing to the sampled picture.
  void bindSampled() const;
  /// Resolves the sampled picture and directs drawing to the plain one.
  void resolve() const;
  /// Copies the plain picture to the window, which must have the same size.
  void present() const { copyTo(0); }
  /// Copies the plain picture to a framebuffer with a picture of the same size.
  void copyTo(const GlFramebuffer& other) const { copyTo(other.name()); }
  /// Returns the plain picture.
  Image read() const;

 private:
  // What is drawn to before resolve().
  const GlFramebuffer& drawn() const {
    if (samples_ > 0) return sampled_;
    return scaler_ ? small_ : plain_;
  }
  void copyTo(GLuint framebuffer) const;
  void attachSampled(GLenum slot, const GlRenderbuffer& buffer, GLenum format) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t sampledWidth_;
  std::uint32_t sampledHeight_;
  GLsizei samples_;                        // 0: not multisampled
  std::unique_ptr<PictureScaler> scaler_;  // null at full size
  GlRenderbuffer sampledColour_;
  GlRenderbuffer depth_;
  GlTexture smallColour_;
  GlTexture plainColour_;
  GlFramebuffer sampled_;
  GlFramebuffer small_;  // not scaled yet
  GlFramebuffer plain_;
};

}  // namespace platon
