#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the beam of light that stands on the ring of the goal, so that the goal is found from every side of the solid.
class BeamPainter {
 public:
  BeamPainter();

  /// Draws the beam, and faintly also what the solid hides of it and of the ring. Along the line of sight the beam
  /// fades, so that it covers nothing on the face of the player. `strength` is 1, or more while a finish is celebrated.
  /// `seconds` is the time of the animation.
  void draw(const StageModel& stage, const Camera& camera, float strength, float seconds);

 private:
  void drawBeam(const StageModel& stage, const Camera& camera, float strength, float seconds);
  void drawHiddenRing(const StageModel& stage, const Camera& camera, float strength, float seconds);

  ShaderProgram beam_;
  ShaderProgram ring_;
  GlVertexArray array_;  // empty: the shader computes the corners from gl_VertexID
};

}  // namespace platon
