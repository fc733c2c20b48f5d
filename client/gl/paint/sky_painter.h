#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/look/scheme.h"

namespace platon {

/// Draws the sky behind everything else: a gradient with a glow, and motes that drift round the solid.
class SkyPainter {
 public:
  SkyPainter();

  void drawSky(const Scheme& scheme);
  /// `radius` is that of the solid, level units; `seconds` the time of the animation.
  void drawMotes(const Scheme& scheme, const Camera& camera, double radius, double seconds);

 private:
  ShaderProgram sky_;
  ShaderProgram motes_;
  GlVertexArray array_;  // empty: the shaders compute positions from gl_VertexID
};

}  // namespace platon
