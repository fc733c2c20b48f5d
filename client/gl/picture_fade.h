#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/render_target.h"
#include "client/gl/shader_program.h"

namespace platon {

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
