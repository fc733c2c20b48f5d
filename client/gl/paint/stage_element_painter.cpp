#include "client/gl/paint/stage_element_painter.h"

#include <cstddef>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/draw_calls.h"
#include "client/gl/paint/face_program.h"
#include "client/scene/look/stage_walls.h"

namespace platon {
namespace {

constexpr auto kWidth = static_cast<float>(StageModel::kRibbonWidth);
// As in the shader, in widths of a segment.
constexpr float kKeyNumber = 4.2F;    // to the right of the middle
constexpr float kPlateNumber = 6.2F;  // to the left of the segment
constexpr float kNumberSize = 6.4F;
constexpr float kTwoDigits = 0.7F;  // size of a number of two digits

constexpr auto kHigh = static_cast<float>(Wall::kHeight);

constexpr glm::vec4 kLock(1.0F, 0.83F, 0.42F, 1);
constexpr glm::vec4 kPlate(0.87F, 0.75F, 1.0F, 1);
constexpr float kOpenAlpha = 0.45F;

// The middle of the number of an element, relative to the middle of its segment.
glm::vec2 offsetOf(const ElementDrawing& drawing, glm::vec2 up) {
  if (drawing.kind == ElementKind::kKey) return kKeyNumber * kWidth * glm::vec2(up.y, -up.x);
  if (drawing.kind != ElementKind::kPlate) return {0, 0};
  const glm::vec2 along = drawing.ends.b - drawing.ends.a;
  const float length = glm::length(along);
  return length > 0 ? kPlateNumber * kWidth / length * glm::vec2(-along.y, along.x) : glm::vec2(0);
}

glm::vec4 colourOf(const ElementDrawing& drawing, bool active) {
  glm::vec4 colour = drawing.kind == ElementKind::kPlate ? kPlate : kLock;
  if (drawing.kind == ElementKind::kDoor && !active) colour.a = kOpenAlpha;
  return colour;
}

bool showsNumber(const ElementDrawing& drawing, bool active) {
  if (drawing.kind == ElementKind::kKey) return active;
  return drawing.kind == ElementKind::kDoor || drawing.kind == ElementKind::kPlate;
}

}  // namespace

StageElementPainter::StageElementPainter() : program_("element") {
  glBindVertexArray(array_.name());
  for (const GLuint attribute : {0U, 1U}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

void StageElementPainter::draw(const Scene& scene, const FaceView& view, bool raised, TextPainter& text) {
  if (scene.elements.active.empty()) return;
  if (stage_.lock() != scene.stage || active_ != scene.elements.active) load(scene);
  const Part& part = parts_[static_cast<std::size_t>(view.face)];
  if (part.count == 0) return;
  const glm::vec2 up = scene.elements.ups[static_cast<std::size_t>(view.face)];
  useOnFace(program_, *scene.stage, view);
  program_.set("lit", litOf(view));
  program_.set("width", kWidth);
  program_.set("up", up);
  program_.set("raised", raised ? kHigh : 0);
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  const auto offset = static_cast<std::size_t>(part.first) * sizeof(Instance);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), bufferOffset(offset));
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), bufferOffset(offset + sizeof(Ribbon)));
  DrawCalls::arraysInstanced(GL_TRIANGLE_STRIP, 4, part.count);
  addNumbers(scene, view, raised, up, text);
  text.flush(raised ? glm::translate(view.toClip, {0, 0, kHigh}) : view.toClip, 0);
}

void StageElementPainter::load(const Scene& scene) {
  stage_ = scene.stage;
  active_ = scene.elements.active;
  parts_.clear();
  std::vector<Instance> instances;
  for (const FaceDrawing& face : scene.stage->faces) {
    parts_.push_back({static_cast<GLsizei>(instances.size()), static_cast<GLsizei>(face.elements.size())});
    for (const ElementDrawing& drawing : face.elements) {
      const float active = active_[drawing.element] != 0 ? 1.0F : 0.0F;
      instances.push_back({drawing.ends, drawing.towards, static_cast<float>(drawing.kind), active});
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)), instances.data(),
               GL_STATIC_DRAW);
}

void StageElementPainter::addNumbers(const Scene& scene, const FaceView& view, bool raised, glm::vec2 up,
                                     TextPainter& text) const {
  for (const ElementDrawing& drawing : scene.stage->faces[static_cast<std::size_t>(view.face)].elements) {
    const bool active = active_[drawing.element] != 0;
    const bool high = active && drawing.kind != ElementKind::kPlate;
    if (!drawing.own || !showsNumber(drawing, active) || high != raised) continue;
    const std::string number = std::to_string(drawing.number);
    const glm::vec2 middle = (drawing.ends.a + drawing.ends.b) / 2.0F + offsetOf(drawing, up);
    const float size = kWidth * kNumberSize * (number.size() > 1 ? kTwoDigits : 1);
    text.addCentred(number, middle, size * up, colourOf(drawing, active));
  }
}

}  // namespace platon
