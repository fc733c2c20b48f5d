#include "client/gl/paint/face_painter.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "client/gl/draw_calls.h"
#include "client/gl/paint/face_program.h"
#include "client/gl/shader_text.h"
#include "client/scene/look/face_light.h"
#include "client/scene/look/high_contrast.h"

namespace platon {
namespace {

constexpr float kSlope = 0.05F;    // how much a face is brighter on the side of the light
constexpr float kGridStep = 60;    // of large faces, on which nothing else may show how a ball moves, level units
constexpr float kLargeFace = 700;  // apothem from which a face has a grid
constexpr float kRim = 16;         // width of what is drawn with the bright edge, level units

}  // namespace

FacePainter::FacePainter() : face_("face"), rim_(shaderText("face.vert"), shaderText("rim.frag")) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void FacePainter::load(const StageModel& stage, bool shadows) {
  const auto apothem = static_cast<float>(stage.mesh.apothem());
  const float inner = 1 - std::min(kRim / apothem, 0.5F);
  std::vector<glm::vec2> corners(stage.mesh.polygon().begin(), stage.mesh.polygon().end());
  const std::size_t edges = corners.size();
  for (std::size_t i = 0; i < edges; ++i) corners.push_back(corners[i] * inner);
  for (std::size_t i = 0; i <= edges; ++i) {
    corners.push_back(corners[i % edges]);
    corners.push_back(corners[edges + i % edges]);
  }
  edges_ = static_cast<GLsizei>(edges);
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(glm::vec2)), corners.data(),
               GL_STATIC_DRAW);
  lightMap_.bake(stage, shadows);
}

// Most of a face needs neither its edges nor a grid.
void FacePainter::draw(const StageModel& stage, std::span<const FaceView> views, bool highContrast) {
  const bool grid = stage.mesh.apothem() > kLargeFace;
  glDisable(GL_BLEND);
  glBindVertexArray(array_.name());
  for (const FaceView& view : views) {
    setLook(rim_, stage, view, highContrast);
    rim_.set("gridStep", grid ? kGridStep : 0.0F);
    if (grid) {
      DrawCalls::arrays(GL_TRIANGLE_FAN, edges_);
      continue;
    }
    DrawCalls::arrays(GL_TRIANGLE_STRIP, 2 * (edges_ + 1), 2 * edges_);
    setLook(face_, stage, view, highContrast);
    DrawCalls::arrays(GL_TRIANGLE_FAN, edges_, edges_);
  }
  glEnable(GL_BLEND);
}

void FacePainter::setLook(ShaderProgram& program, const StageModel& stage, const FaceView& view,
                          bool highContrast) const {
  useOnFace(program, stage, view);
  lightMap_.bind(program, view.face);
  const Colour colour = stage.faces[static_cast<std::size_t>(view.face)].colour;
  program.set("colour", highContrast ? highContrastFace(colour) : colour);
  program.set("lit", litOf(view));
  const glm::vec2 aside(faceLight(stage.mesh, view.face));
  program.set("slope", aside * (kSlope / static_cast<float>(stage.mesh.apothem())));
}

}  // namespace platon
