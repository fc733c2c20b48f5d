#pragma once

#include "client/camera.h"
#include "client/gl_handle.h"
#include "client/scene.h"
#include "client/shader_program.h"
#include "client/text_painter.h"

namespace platon {

/// Draws players: small spheres with a number.
class BallPainter {
 public:
  BallPainter();

  void draw(const PlayerDrawing& player, const Camera& camera, TextPainter& text);

 private:
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer points_;
  GlBuffer triangles_;
  GLsizei count_ = 0;
};

}  // namespace platon
