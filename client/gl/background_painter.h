#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"

namespace platon {

/// Fills what nothing else covers: the dark, and stars that stand still in space.
class BackgroundPainter {
 public:
  BackgroundPainter();

  void draw(const Camera& camera);

 private:
  ShaderProgram dark_;
  ShaderProgram stars_;
  GlVertexArray array_;  // empty: all places come from their numbers
};

}  // namespace platon
