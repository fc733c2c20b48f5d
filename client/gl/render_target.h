#pragma once

#include <cstdint>
#include <memory>

#include "client/gl/gl_objects.h"
#include "client/gl/image.h"
#include "client/gl/shader_program.h"

namespace platon {

/// Draws a picture over the whole of another one, interpolated linearly. Drivers that draw with the processor do this
/// faster than glBlitFramebuffer.
class PictureScaler {
 public:
  PictureScaler();

  /// Draws `picture` over the viewport. Leaves the depth test off, and blending on.
  void draw(const GlTexture& picture);

 private:
  ShaderProgram program_;
  GlVertexArray array_;  // empty: the shader computes the corners from gl_VertexID
};

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
  /// Directs drawing to the plain picture.
  void bindPlain() const;
  /// Copies the plain picture into that of `other`, which has room for it, with its lower left corner at `x`, `y`.
  /// Changes the bound framebuffer.
  void copyInto(const RenderTarget& other, std::uint32_t x, std::uint32_t y) const;
  /// Makes the plain picture black.
  void clearPlain() const;
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

/// Keeps a picture and draws it over later ones, so that a cut of the camera becomes a cross-fade.
class PictureFade {
 public:
  PictureFade();

  /// Keeps the plain picture of `target`. Changes the bound framebuffer.
  void keep(const RenderTarget& target);
  /// Draws the kept picture over the viewport, with this opacity, 0 … 1. Leaves the depth test off, and blending on.
  void draw(double opacity);

 private:
  ShaderProgram program_;
  GlVertexArray array_;  // empty: the shader computes the corners from gl_VertexID
  GlTexture picture_;
  GlFramebuffer framebuffer_;
};

}  // namespace platon
