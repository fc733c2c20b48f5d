#pragma once

#include <cstdint>

#include "client/gl/gl_handle.h"
#include "client/gl/image.h"

namespace platon {

/// A multisampled picture with depth, which may be smaller, and the plain picture that it is resolved to.
class RenderTarget {
 public:
  /// `width` × `height` in pixels, at least 1 × 1. `samples` per pixel, limited by the driver. The
  /// multisampled picture has `scale` times the size, more than 0. Throws std::runtime_error if the driver does not
  /// support the size.
  RenderTarget(std::uint32_t width, std::uint32_t height, int samples, double scale = 1);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// Directs drawing to the multisampled picture.
  void bindSampled() const;
  /// Resolves the multisampled picture and directs drawing to the plain one, which has no depth.
  void resolve() const;
  /// Copies the plain picture to the window, which must have the same size.
  void present() const;
  /// Returns the plain picture.
  Image read() const;

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t sampledWidth_;
  std::uint32_t sampledHeight_;
  GlRenderbuffer sampledColour_;
  GlRenderbuffer sampledDepth_;
  GlRenderbuffer smallColour_;
  GlRenderbuffer plainColour_;
  GlFramebuffer sampled_;
  GlFramebuffer small_;  // resolved, but not scaled yet
  GlFramebuffer plain_;
};

}  // namespace platon
