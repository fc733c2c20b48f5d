#pragma once

#include <span>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Makes `program`, whose shaders include face.glsl, that of the following draw calls, which draw on this face.
void useOnFace(ShaderProgram& program, const StageModel& stage, const FaceView& view);

/// How bright a face is: brightest where it faces the light, which moves with the camera.
float litOf(const FaceView& view);

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
  void setAppearance(ShaderProgram& program, const StageModel& stage, const FaceView& view, bool highContrast) const;

  LightMap lightMap_;
  ShaderProgram face_;
  ShaderProgram rim_;
  GlVertexArray array_;
  GlBuffer corners_;   // of the face, of its inner part, and of the rim between them
  GLsizei edges_ = 0;  // of a face
};

}  // namespace platon
