#pragma once

#include <memory>
#include <span>
#include <vector>

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/gl/stage_element_painter.h"
#include "client/gl/text_painter.h"
#include "client/scene/face_view.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws the solid and everything on its faces.
class StagePainter {
 public:
  StagePainter();

  /// Draws the faces, with depth.
  void draw(const std::shared_ptr<const StageModel>& stage, std::span<const FaceView> views);
  /// Draws segments, elements, marks, markers, face numbers and shadows on the faces. `seconds` is the time of the
  /// animation.
  void drawOnFaces(const Scene& scene, std::span<const FaceView> views, float seconds, TextPainter& text);

 private:
  struct Ribbons {
    GLsizei first = 0;
    GLsizei count = 0;
  };

  // A list of marks for the shader.
  struct Marks {
    FaceMarks loaded;
    std::vector<Ribbons> parts;  // by face
    GlVertexArray array;
    GlBuffer buffer;
  };

  struct Look {
    int kind = 0;  // as in the shader
    float radius = 0;
    float reach = 0;  // half side of the square that is drawn
  };

  void load(const StageModel& stage);
  void drawRibbons(const StageModel& stage, const FaceView& view, bool shadow);
  void drawMarks(const Scene& scene, const FaceView& view, const FaceMarks& marks, Marks& kept);
  void load(const StageModel& stage, const FaceMarks& marks, Marks& kept);
  void drawMarkers(const Scene& scene, const FaceView& view, float seconds);
  void drawMarker(const SolidMesh& mesh, const FaceView& view, const Marker& marker, const Look& look);
  void drawShadows(const Scene& scene, const FaceView& view);
  void drawLabels(const StageModel& stage, const FaceView& view, TextPainter& text) const;

  std::weak_ptr<const StageModel> loaded_;
  ShaderProgram face_;
  ShaderProgram ribbon_;
  ShaderProgram marker_;
  ShaderProgram mark_;
  StageElementPainter elementPainter_;
  GlVertexArray faceArray_;
  GlVertexArray ribbonArray_;
  GlVertexArray markerArray_;  // empty: the shader computes the corners from gl_VertexID
  GlBuffer corners_;
  GlBuffer ends_;
  std::vector<Ribbons> ribbons_;  // by face: its part of ends_
  Marks marksBelow_;
  Marks marksAbove_;
};

}  // namespace platon
