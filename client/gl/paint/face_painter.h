#pragma once

#include <span>

#include "client/gl/gl_handle.h"
#include "client/gl/paint/light_map.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the faces of the solid, with depth.
class FacePainter {
 public:
  FacePainter();

  /// Replaces the stage whose faces are drawn. Changes the bound framebuffer.
  void load(const StageModel& stage, bool shadows);
  /// Whether shadows are smooth between the points of the light map.
  void setFine(bool fine) { lightMap_.setFine(fine); }
  /// Draws these faces of the stage that was loaded.
  void draw(const StageModel& stage, std::span<const FaceView> views, bool highContrast);

 private:
  void setLook(ShaderProgram& program, const StageModel& stage, const FaceView& view, bool highContrast) const;

  LightMap lightMap_;
  ShaderProgram face_;
  ShaderProgram rim_;
  GlVertexArray array_;
  GlBuffer corners_;   // of the face, of its inner part, and of the rim between them
  GLsizei edges_ = 0;  // of a face
};

}  // namespace platon
