#pragma once

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/scene/ball_motion.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"

namespace platon {

/// Draws players: balls that roll. Those of others have a number. A bright spot shows where up is.
class BallPainter {
 public:
  BallPainter();

  /// Whether balls are so round that it is seen in large pictures.
  void setFine(bool fine) { fine_ = fine; }
  void draw(const PlayerDrawing& player, const BallMotion& motion, const Camera& camera, bool highContrast,
            TextPainter& text);

 private:
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer points_;
  GlBuffer triangles_;
  GLsizei fineCount_ = 0;    // of the indices of the fine ball, which come first
  GLsizei coarseCount_ = 0;  // of those of the other one
  bool fine_ = true;
};

}  // namespace platon
