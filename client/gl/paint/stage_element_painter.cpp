#include "client/gl/paint/stage_element_painter.h"

#include <cstddef>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/gl_objects.h"
#include "client/gl/paint/face_painter.h"
#include "client/gl/shader_program.h"
#include "client/scene/walls.h"

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

// The number of an element, as it is drawn.
struct ShownNumber {
  glm::vec2 offset{0};  // of its middle from the middle of the segment
  glm::vec4 colour = kLock;
  bool high = false;  // on the walls of the element, not flat on the face
};

std::optional<ShownNumber> shownNumberOf(const ElementDrawing& drawing, bool active, glm::vec2 up) {
  switch (drawing.kind) {
    case ElementKind::kKey:
      if (!active) return std::nullopt;
      return ShownNumber{kKeyNumber * kWidth * glm::vec2(up.y, -up.x), kLock, true};
    case ElementKind::kDoor:
      return ShownNumber{{0, 0}, active ? kLock : glm::vec4(glm::vec3(kLock), kOpenAlpha), active};
    case ElementKind::kPlate: {
      const glm::vec2 along = drawing.ends.b - drawing.ends.a;
      const float length = glm::length(along);
      const glm::vec2 left = length > 0 ? glm::vec2(-along.y, along.x) / length : glm::vec2(0);
      return ShownNumber{kPlateNumber * kWidth * left, kPlate, false};
    }
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
    case ElementKind::kTimed:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::string elementKindsOfShader() {
  std::string text = "const int kKinds = " + std::to_string(kElementKinds.size()) + ";\n";
  for (std::size_t kind = 0; kind < kElementKinds.size(); ++kind)
    text += "const int kind_" + std::string(wordOf(kElementKinds[kind])) + " = " + std::to_string(kind) + ";\n";
  return text;
}

StageElementPainter::StageElementPainter()
    : program_(elementKindsOfShader() + shaderText("element.vert"), elementKindsOfShader() + shaderText("element.frag"),
               "element") {
  glBindVertexArray(array_.name());
  for (const GLuint attribute : {0U, 1U}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

void StageElementPainter::draw(const Scene& scene, const FaceView& view, bool raised, TextPainter& text) {
  if (scene.elements.active.empty()) return;
  if (stage_.lock() != scene.stage || active_ != scene.elements.active || clocks_ != scene.elements.clocks) load(scene);
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
  clocks_ = scene.elements.clocks;
  parts_.clear();
  std::vector<Instance> instances;
  for (const FaceDrawing& face : scene.stage->faces) {
    parts_.push_back({static_cast<GLsizei>(instances.size()), static_cast<GLsizei>(face.elements.size())});
    for (const ElementDrawing& drawing : face.elements) {
      const float active = active_[drawing.element] != 0 ? 1.0F : 0.0F;
      const glm::vec2 look =
          drawing.kind == ElementKind::kTimed ? glm::vec2(clocks_[drawing.element], 0) : drawing.towards;
      instances.push_back({drawing.ends, look, static_cast<float>(drawing.kind), active});
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
    const auto shown = shownNumberOf(drawing, active, up);
    if (!drawing.own || !shown || shown->high != raised) continue;
    const std::string number = std::to_string(drawing.number);
    const glm::vec2 middle = (drawing.ends.a + drawing.ends.b) / 2.0F + shown->offset;
    const float size = kWidth * kNumberSize * (number.size() > 1 ? kTwoDigits : 1);
    text.addCentred(number, middle, size * up, shown->colour);
  }
}

}  // namespace platon
