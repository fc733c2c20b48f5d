#include "client/gl/paint/wall_painter.h"

#include <cstddef>
#include <cstdint>

#include "client/gl/draw_calls.h"
#include "client/gl/paint/face_program.h"
#include "client/scene/look/face_light.h"

namespace platon {

WallPainter::WallPainter() : program_("wall") {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
  constexpr GLsizei kSize = sizeof(WallVertex);
  for (const GLuint attribute : {0U, 1U, 2U, 3U}) glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kSize, bufferOffset(offsetof(WallVertex, place)));
  glVertexAttribPointer(1, 3, GL_BYTE, GL_TRUE, kSize, bufferOffset(offsetof(WallVertex, normal)));
  glVertexAttribPointer(2, 3, GL_UNSIGNED_BYTE, GL_TRUE, kSize, bufferOffset(offsetof(WallVertex, colour)));
  glVertexAttribPointer(3, 2, GL_BYTE, GL_TRUE, kSize, bufferOffset(offsetof(WallVertex, aside)));
}

void WallPainter::load(const WallMesh& mesh) {
  faces_ = mesh.faces;
  const auto bytes = [](const auto& values) { return static_cast<GLsizeiptr>(values.size() * sizeof(values[0])); };
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, bytes(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.triangles), mesh.triangles.data(), GL_STATIC_DRAW);
}

void WallPainter::draw(const StageModel& stage, std::span<const FaceView> views, glm::uvec2 pixels, bool highContrast,
                       const std::optional<EdgeCrossing::Tint>& tint) {
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBindVertexArray(array_.name());
  program_.use();
  program_.set("pixels", glm::vec2(pixels) / 2.0F);
  program_.set("asideScale", static_cast<float>(127 / WallVertex::kAsideScale));
  for (const FaceView& view : views) {
    const auto face = static_cast<std::size_t>(view.face);
    if (face >= faces_.size() || faces_[face].count == 0) continue;
    program_.set("toClip", view.toClip);
    program_.set("eye", view.eye);
    program_.set("light", glm::vec3(faceLight(stage.mesh, view.face)));
    program_.set("ground", highContrast ? Colour(1) : stage.faces[face].colour);
    program_.set("lit", litOf(view));
    const bool tinted = tint && tint->face == view.face;
    program_.set("up", tinted ? tint->up * static_cast<float>(tint->light) : glm::vec2(0));
    DrawCalls::elements(GL_TRIANGLES, static_cast<GLsizei>(faces_[face].count), GL_UNSIGNED_INT,
                        bufferOffset(faces_[face].first * sizeof(std::uint32_t)));
  }
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
}

}  // namespace platon
