#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"

namespace platon {

/// Draws the dark background and stars at fixed directions in space, behind everything else.
class BackgroundPainter {
 public:
  BackgroundPainter();

  void draw(const Camera& camera);

 private:
  ShaderProgram dark_;
  ShaderProgram stars_;
  GlVertexArray array_;  // empty: the shaders compute positions from gl_VertexID
};

}  // namespace platon
