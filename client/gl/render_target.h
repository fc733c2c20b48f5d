#pragma once

#include <cstdint>

#include "client/gl/gl_handle.h"
#include "client/gl/image.h"

namespace platon {

/// What is drawn into: a multisampled picture with depth, and the plain picture that it is resolved to.
class RenderTarget {
 public:
  /// In pixels, at least 1. `samples` as far as the driver has them. Throws std::runtime_error when the driver refuses.
  RenderTarget(std::uint32_t width, std::uint32_t height, int samples);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// Drawing goes to the multisampled picture.
  void bindSampled() const;
  /// Resolves; from now on drawing goes to the plain picture, which has no depth.
  void resolve() const;
  /// Copies the plain picture to the window's, of the same size.
  void present() const;
  /// The plain picture.
  Image read() const;

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  GlRenderbuffer sampledColour_;
  GlRenderbuffer sampledDepth_;
  GlRenderbuffer plainColour_;
  GlFramebuffer sampled_;
  GlFramebuffer plain_;
};

}  // namespace platon
