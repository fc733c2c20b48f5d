#pragma once

#include <optional>
#include <span>

#include "client/gl/gl_handle.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/look/edge_crossing.h"
#include "client/scene/look/wall_mesh.h"
#include "client/scene/stage_model.h"

namespace platon {

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

}  // namespace platon
