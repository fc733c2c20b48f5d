#pragma once

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the beam of light that stands on the ring of the goal, so that the goal is found from every side of the solid.
class BeamPainter {
 public:
  /// Draws the beam, and a line of dashes for what the solid hides of it. Along the line of sight the beam fades, so
  /// that it covers nothing on the face of the player. `strength` is 1, or more while a finish is celebrated.
  /// `seconds` is the time of the animation.
  void draw(const StageModel& stage, const Camera& camera, float strength, float seconds);

 private:
  ShaderProgram beam_{"beam"};
  GlVertexArray array_;  // empty: the shader computes the corners from gl_VertexID
};

}  // namespace platon
