#pragma once

#include <array>

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Draws round things that lie on faces.
class MarkerPainter {
 public:
  enum class Kind : std::uint8_t { kGoal, kBurst, kStart, kSign, kShadow, kEdge, kArrow };

  struct Look {
    Kind kind = Kind::kShadow;
    float radius = 0;   ///< level units
    float reach = 0;    ///< half the side of the square that is drawn, level units
    float opened = 0;   ///< of a kGoal, or how far a kBurst is, or how strong a kEdge or kArrow: 0 … 1
    float height = 1;   ///< of what is drawn, in widths
    float seconds = 0;  ///< time of the animation of a kGoal
    glm::vec2 form{0};  ///< of a kSign: corners of the ring, dots
  };

  MarkerPainter();

  /// Draws the part of a marker on this face, if there is one.
  void draw(const StageModel& stage, const FaceView& view, const Marker& marker, const Look& look);

 private:
  std::array<ShaderProgram, 7> programs_;  // by kind
  GlVertexArray array_;                    // empty: the shader computes the corners from gl_VertexID
};

}  // namespace platon
