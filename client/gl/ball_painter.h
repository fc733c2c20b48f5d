#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"

namespace platon {

/// Draws players: balls with a number.
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
