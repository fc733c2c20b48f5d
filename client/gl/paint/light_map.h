#pragma once

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/stage_model.h"

namespace platon {

/// The light on the faces of a stage: a texture with a layer for each face, 1 where nothing shades the face. Shadows of
/// the walls and occlusion along walls and edges are drawn into it once, so that a frame costs one lookup.
class LightMap {
 public:
  LightMap();

  /// Draws the light of `stage`. Without `shadows`, only that along the edges of the faces. Changes the bound
  /// framebuffer, the viewport, depth test and blending.
  void bake(const StageModel& stage, bool shadows);

  /// Whether the light is interpolated between the points of the texture, or that of the nearest one. Drivers that draw
  /// with the processor take a third less time for the nearest.
  void setFine(bool fine) { filter_ = fine ? GL_LINEAR : GL_NEAREST; }
  /// Binds the texture to unit 0 and sets what shaders/light.glsl needs of `program`, which is in use.
  void bind(ShaderProgram& program, int face) const;

 private:
  void allocate(const StageModel& stage);
  void bakeFace(const StageModel& stage, int face, bool shadows);

  ShaderProgram ground_;
  ShaderProgram shade_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  GlVertexArray array_;
  GlBuffer ends_;
  GLint filter_ = GL_LINEAR;
  GLsizei size_ = 0;  // of a layer, texels
  float reach_ = 1;   // half the side of the square that a layer shows, level units
};

}  // namespace platon
