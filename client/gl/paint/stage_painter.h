#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "client/gl/gl_objects.h"
#include "client/gl/paint/face_painter.h"
#include "client/gl/paint/stage_element_painter.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/scene/edge_crossing.h"
#include "client/scene/face_view.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/scene/stage_motion.h"
#include "client/scene/walls.h"

namespace platon {

/// Draws round things that lie on faces.
class MarkerPainter {
 public:
  enum class Kind : std::uint8_t { kGoal, kBurst, kStart, kSign, kShadow, kEdge, kArrow, kWave };

  struct Appearance {
    Kind kind = Kind::kShadow;
    float radius = 0;   ///< level units
    float reach = 0;    ///< half the side of the square that is drawn, level units
    float opened = 0;   ///< of a kGoal, or how far a kBurst or kWave is, or how strong a kEdge or kArrow: 0 … 1
    float height = 1;   ///< of what is drawn, in widths
    float seconds = 0;  ///< time of the animation of a kGoal
    glm::vec2 form{0};  ///< of a kSign: corners of the ring, dots
  };

  MarkerPainter();

  /// Draws the part of a marker on this face, if there is one.
  void draw(const StageModel& stage, const FaceView& view, const Marker& marker, const Appearance& appearance);

 private:
  std::array<ShaderProgram, 8> programs_;  // by kind
  GlVertexArray array_;                    // empty: the shader computes the corners from gl_VertexID
};

/// Draws walls, with depth.
class WallPainter {
 public:
  WallPainter();

  /// Replaces the walls that are drawn.
  void load(const WallMesh& mesh);
  /// Draws the walls of these faces into a picture of this size, floors with this tint.
  void draw(const StageModel& stage, std::span<const FaceView> views, glm::uvec2 pixels, bool highContrast,
            const std::optional<EdgeCrossing::Tint>& tint);

 private:
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer vertices_;
  GlBuffer triangles_;
  std::vector<WallMesh::Part> faces_;
};

/// Draws the solid and everything on its faces.
class StagePainter {
 public:
  /// What changes from picture to picture and belongs to no level.
  struct Decoration {
    float seconds = 0;     ///< time of the animation
    bool numbers = false;  ///< faces have numbers instead of signs
    FaceMarks trails;      ///< of the balls; null without any
    GoalMotion goal;
    EdgeCrossing crossing;
  };

  StagePainter();

  /// Loads what the scene needs. Changes the bound framebuffer, so it comes before the picture is begun.
  /// With `fine`, shadows are smoother; without `animated`, elements change at once.
  void prepare(const Scene& scene, bool fine, bool highContrast, bool animated);
  /// Draws the faces, with depth.
  void drawFaces(const StageModel& stage, std::span<const FaceView> views) { faces_.draw(stage, views, highContrast_); }
  /// Draws what lies flat on the faces: signs or numbers, marks, markers, elements, trails and shadows.
  void drawBelow(const Scene& scene, std::span<const FaceView> views, const Decoration& decoration, TextPainter& text);
  /// Draws the walls, with depth, into a picture of this size in pixels.
  void drawWalls(const StageModel& stage, std::span<const FaceView> views, glm::uvec2 pixels,
                 const EdgeCrossing& crossing);
  /// Draws what lies on the walls.
  void drawAbove(const Scene& scene, std::span<const FaceView> views, TextPainter& text);

 private:
  struct Part {
    GLsizei first = 0;
    GLsizei count = 0;
  };

  // A list of marks for the shader.
  struct Marks {
    FaceMarks loaded;
    std::vector<Part> parts;  // by face
    GlVertexArray array;
    GlBuffer buffer;
  };

  void load(const StageModel& stage);
  void drawMarks(const Scene& scene, const FaceView& view, const FaceMarks& marks, Marks& kept);
  void load(const StageModel& stage, const FaceMarks& marks, Marks& kept);
  void drawSign(const StageModel& stage, const FaceView& view);
  void drawMarkers(const Scene& scene, const FaceView& view, const Decoration& decoration);
  void drawCrossing(const StageModel& stage, const FaceView& view, const EdgeCrossing& crossing);
  void drawShadows(const Scene& scene, const FaceView& view);
  void drawLabels(const StageModel& stage, const FaceView& view, TextPainter& text) const;

  std::weak_ptr<const StageModel> loaded_;
  bool highContrast_ = false;
  ShaderProgram mark_;
  StageElementPainter elementPainter_;
  FacePainter faces_;
  MarkerPainter markers_;
  WallPainter walls_;
  WallPainter elementWalls_;
  std::optional<EdgeMeetings> meetings_;  // of the stage that is loaded
  ElementMotion elements_;
  std::vector<double> shares_;  // ElementMotion::shares that are loaded
  std::vector<FaceSign> signs_;
  Marks trails_;
  Marks marksBelow_;
  Marks marksAbove_;
};

}  // namespace platon
