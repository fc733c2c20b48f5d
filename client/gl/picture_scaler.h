#pragma once

#include "client/gl/gl_handle.h"
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

}  // namespace platon
