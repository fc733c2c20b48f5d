#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the beam of light that stands on the goal, so that the goal is found from every side of the solid.
class BeamPainter {
 public:
  BeamPainter();

  /// Draws the beam, and faintly also the part of it that the solid hides. Along the line of sight it fades, so that it
  /// covers nothing on the face of the player. `strength` is 1, or more while a finish is celebrated.
  void draw(const StageModel& stage, const Camera& camera, float strength);

 private:
  ShaderProgram program_;
  GlVertexArray array_;  // empty: the shader computes the corners from gl_VertexID
};

}  // namespace platon
