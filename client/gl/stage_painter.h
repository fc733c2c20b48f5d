#pragma once

#include <memory>
#include <span>
#include <vector>

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/scene/face_view.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the solid and all that lies on its faces.
class StagePainter {
 public:
  StagePainter();

  /// The solid's outside: fills the depth, too.
  void draw(const std::shared_ptr<const StageModel>& stage, std::span<const FaceView> views);
  /// Lines, marks, numbers and the players' shadows, in front of the faces. `seconds` drives what moves of itself.
  void drawOnFaces(const Scene& scene, std::span<const FaceView> views, float seconds, TextPainter& text);

 private:
  struct Ribbons {
    GLsizei first = 0;
    GLsizei count = 0;
  };

  struct Look {
    int kind = 0;  // as in the shader
    float radius = 0;
    float reach = 0;  // of all that is drawn
  };

  void load(const StageModel& stage);
  void beginFace(ShaderProgram& program, const StageModel& stage, const FaceView& view) const;
  void drawRibbons(const StageModel& stage, const FaceView& view, bool shadow);
  void drawMarkers(const Scene& scene, const FaceView& view, float seconds);
  void drawMarker(const SolidMesh& mesh, const FaceView& view, const Marker& marker, const Look& look);
  void drawShadows(const Scene& scene, const FaceView& view);
  void drawLabels(const StageModel& stage, const FaceView& view, TextPainter& text) const;

  std::weak_ptr<const StageModel> loaded_;
  ShaderProgram face_;
  ShaderProgram ribbon_;
  ShaderProgram marker_;
  GlVertexArray faceArray_;
  GlVertexArray ribbonArray_;
  GlVertexArray markerArray_;  // empty: its corners come from their numbers
  GlBuffer corners_;
  GlBuffer ends_;
  std::vector<Ribbons> ribbons_;  // of every face, in ends_
};

}  // namespace platon
