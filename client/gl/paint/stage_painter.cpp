#include "client/gl/paint/stage_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/gl/gl_objects.h"
#include "client/gl/paint/face_painter.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/walls.h"

namespace platon {
namespace {

ShaderProgram programOf(const std::string& marker) {
  return {shaderText("marker.vert"), shaderText(marker + ".frag"), marker};
}

}  // namespace

// A program for each kind: drivers that draw with the processor execute all branches of a shader.
MarkerPainter::MarkerPainter()
    : programs_{programOf("goal"),   programOf("burst"), programOf("start"), programOf("sign"),
                programOf("shadow"), programOf("edge"),  programOf("arrow"), programOf("wave")} {}

void MarkerPainter::draw(const StageModel& stage, const FaceView& view, const Marker& marker,
                         const Appearance& appearance) {
  const auto here = markerOn(stage.mesh, view.face, marker, double{appearance.reach});
  if (!here) return;
  ShaderProgram& program = programs_[static_cast<std::size_t>(appearance.kind)];
  useOnFace(program, stage, view);
  program.set("centre", here->place);
  program.set("angle", static_cast<float>(here->angle));
  program.set("radius", appearance.radius);
  program.set("reach", glm::vec2(appearance.reach, appearance.reach * appearance.height));
  program.set("opened", appearance.opened);
  program.set("seconds", appearance.seconds);
  program.set("form", appearance.form);
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
}

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

namespace {

constexpr float kNumberedFace = 700;  // apothem from which a face has several numbers
constexpr float kLabelStep = 640;
constexpr float kGoalReach = 4;     // radius of the goal's glow in goal radii
constexpr float kBurstReach = 8;    // of the burst at a finish
constexpr float kGlowLength = 110;  // of an edge that is lit, to each side of the ball, level units
constexpr float kGlowWidth = 22;
constexpr float kWaveRadius = 120;  // of the wave at a crossing, at its end
constexpr float kArrowLength = 32;
constexpr glm::vec4 kLabelColour(1, 1, 1, 0.13F);

// A FaceMark for the shader.
struct MarkInstance {
  glm::vec2 a;
  glm::vec2 b;
  float width;
  glm::vec4 colour;
};

template <class Value>
void fill(const GlBuffer& buffer, const std::vector<Value>& values) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), GL_STATIC_DRAW);
}

bool inPolygon(const SolidMesh& mesh, glm::dvec2 point, double margin) {
  return std::all_of(mesh.edgeNormals().begin(), mesh.edgeNormals().end(),
                     [&](glm::dvec2 normal) { return glm::dot(normal, point) < mesh.apothem() - margin; });
}

}  // namespace

StagePainter::StagePainter() : mark_("mark") {}

void StagePainter::prepare(const Scene& scene, bool fine, bool highContrast, bool animated) {
  const bool loaded = loaded_.lock() == scene.stage && highContrast_ == highContrast;
  highContrast_ = highContrast;
  if (!loaded) load(*scene.stage);
  loaded_ = scene.stage;
  faces_.setFine(fine);
  elements_.advance(scene.elements.active, scene.seconds);
  if (!animated) elements_.settle();
  if (shares_ == elements_.shares()) return;
  shares_ = elements_.shares();
  elementWalls_.load(makeWallMesh(scene.stage->mesh, elementWallsOf(*scene.stage, shares_), *meetings_));
}

void StagePainter::drawBelow(const Scene& scene, std::span<const FaceView> views, const Decoration& decoration,
                             TextPainter& text) {
  for (const FaceView& view : views) {
    decoration.numbers ? drawLabels(*scene.stage, view, text) : drawSign(*scene.stage, view);
    drawMarks(scene, view, scene.marksBelow, marksBelow_);
    drawMarkers(scene, view, decoration);
    elementPainter_.draw(scene, view, false, text);
    drawMarks(scene, view, decoration.trails, trails_);
    drawShadows(scene, view);
    drawCrossing(*scene.stage, view, decoration.crossing);
  }
}

void StagePainter::drawSign(const StageModel& stage, const FaceView& view) {
  const FaceSign& sign = signs_[static_cast<std::size_t>(view.face)];
  MarkerPainter::Appearance appearance{MarkerPainter::Kind::kSign, sign.radius, sign.radius * 1.1F};
  appearance.form = glm::vec2(sign.corners, sign.dots);
  markers_.draw(stage, view, {view.face, sign.place, 0}, appearance);
}

void StagePainter::drawWalls(const StageModel& stage, std::span<const FaceView> views, glm::uvec2 pixels,
                             const EdgeCrossing& crossing) {
  walls_.draw(stage, views, pixels, highContrast_, crossing.tint());
  if (!shares_.empty()) elementWalls_.draw(stage, views, pixels, highContrast_, crossing.tint());
}

void StagePainter::drawAbove(const Scene& scene, std::span<const FaceView> views, TextPainter& text) {
  for (const FaceView& view : views) elementPainter_.draw(scene, view, true, text);
  glDisable(GL_DEPTH_TEST);
  for (const FaceView& view : views) drawMarks(scene, view, scene.marksAbove, marksAbove_);
  glEnable(GL_DEPTH_TEST);
}

// Baking changes the state of OpenGL, so a stage is loaded before the picture begins.
void StagePainter::load(const StageModel& stage) {
  meetings_.emplace(edgeMeetingsOf(stage));
  walls_.load(makeWallMesh(stage.mesh, wallsOf(stage), *meetings_));
  faces_.load(stage, !highContrast_);
  signs_ = signsOf(stage);
  shares_.clear();
  elements_ = ElementMotion();
}

void StagePainter::drawMarks(const Scene& scene, const FaceView& view, const FaceMarks& marks, Marks& kept) {
  if (marks == nullptr || marks->empty()) return;
  if (kept.loaded != marks) load(*scene.stage, marks, kept);
  const Part& part = kept.parts[static_cast<std::size_t>(view.face)];
  if (part.count == 0) return;
  useOnFace(mark_, *scene.stage, view);
  glBindVertexArray(kept.array.name());
  glBindBuffer(GL_ARRAY_BUFFER, kept.buffer.name());
  constexpr GLuint kAttributes[] = {4, 1, 4};  // floats of ends, width and colour
  std::size_t offset = static_cast<std::size_t>(part.first) * sizeof(MarkInstance);
  for (GLuint index = 0; index < std::size(kAttributes); ++index) {
    const GLuint size = kAttributes[index];
    glEnableVertexAttribArray(index);
    glVertexAttribDivisor(index, 1);
    glVertexAttribPointer(index, static_cast<GLint>(size), GL_FLOAT, GL_FALSE, sizeof(MarkInstance),
                          bufferOffset(offset));
    offset += size * sizeof(float);
  }
  DrawCalls::arraysInstanced(GL_TRIANGLE_STRIP, 4, part.count);
}

void StagePainter::load(const StageModel& stage, const FaceMarks& marks, Marks& kept) {
  kept.loaded = marks;
  kept.parts.clear();
  std::vector<MarkInstance> instances;
  for (int face = 0; face < stage.mesh.faces(); ++face) {
    const auto first = static_cast<GLsizei>(instances.size());
    for (const FaceMark& mark : *marks) {
      if (mark.face == face) instances.push_back({mark.a, mark.b, mark.width, mark.colour});
    }
    kept.parts.push_back({first, static_cast<GLsizei>(instances.size()) - first});
  }
  fill(kept.buffer, instances);
}

void StagePainter::drawMarkers(const Scene& scene, const FaceView& view, const Decoration& decoration) {
  const StageModel& stage = *scene.stage;
  constexpr auto kStartRadius = static_cast<float>(StageModel::kPlayerRadius * 1.6);
  constexpr auto goalRadius = static_cast<float>(StageModel::kGoalRadius);
  using Kind = MarkerPainter::Kind;
  markers_.draw(stage, view, stage.start, {Kind::kStart, kStartRadius, kStartRadius * 1.2F});
  MarkerPainter::Appearance goal{Kind::kGoal, goalRadius, goalRadius * kGoalReach};
  goal.opened = static_cast<float>(decoration.goal.opened());
  goal.seconds = decoration.seconds;
  markers_.draw(stage, view, stage.goal, goal);
  if (decoration.goal.burst() >= 1) return;
  MarkerPainter::Appearance burst{Kind::kBurst, goalRadius, goalRadius * kBurstReach};
  burst.opened = static_cast<float>(decoration.goal.burst());
  markers_.draw(stage, view, stage.goal, burst);
}

void StagePainter::drawCrossing(const StageModel& stage, const FaceView& view, const EdgeCrossing& crossing) {
  for (const EdgeCrossing::Glow& glow : crossing.glows()) {
    MarkerPainter::Appearance appearance{MarkerPainter::Kind::kEdge, kGlowWidth, kGlowLength};
    appearance.opened = static_cast<float>(glow.light);
    appearance.height = kGlowWidth / kGlowLength;
    appearance.form.x = kGlowLength;
    markers_.draw(stage, view, glow.foot, appearance);
  }
  if (const std::optional<EdgeCrossing::Wave> wave = crossing.wave()) {
    MarkerPainter::Appearance appearance{MarkerPainter::Kind::kWave, kWaveRadius, kWaveRadius * 1.2F};
    appearance.opened = static_cast<float>(wave->part);
    markers_.draw(stage, view, wave->foot, appearance);
  }
  const std::optional<EdgeCrossing::Arrow> arrow = crossing.arrow();
  if (!arrow) return;
  MarkerPainter::Appearance appearance{MarkerPainter::Kind::kArrow, kArrowLength / 2, kArrowLength / 2 * 1.4F};
  appearance.opened = static_cast<float>(arrow->light);
  markers_.draw(stage, view, arrow->place, appearance);
}

void StagePainter::drawShadows(const Scene& scene, const FaceView& view) {
  const SolidMesh& mesh = scene.stage->mesh;
  constexpr auto kBallRadius = static_cast<float>(StageModel::kPlayerRadius);
  const MarkerPainter::Appearance appearance{MarkerPainter::Kind::kShadow, kBallRadius, kBallRadius * 1.6F};
  for (const PlayerDrawing& player : scene.players) {
    const int face = mesh.faceTowards(player.pose.position);
    const glm::dvec4 place = glm::inverse(mesh.faceToWorld(face)) * glm::dvec4(player.pose.position, 1);
    const glm::vec2 fall = -0.4F * kBallRadius * glm::vec2(faceLight(mesh, face));  // away from the light
    markers_.draw(*scene.stage, view, {face, glm::vec2(place) + fall, 0}, appearance);
  }
}

void StagePainter::drawLabels(const StageModel& stage, const FaceView& view, TextPainter& text) const {
  const std::string& label = stage.faces[static_cast<std::size_t>(view.face)].label;
  const auto apothem = static_cast<float>(stage.mesh.apothem());
  if (apothem < kNumberedFace) {
    text.addCentred(label, {0, 0}, apothem * 0.8F, kLabelColour);
  } else {
    const glm::ivec2 near(glm::round(glm::vec2(view.eye) / kLabelStep));
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        const glm::vec2 middle = glm::vec2(near + glm::ivec2(i, j)) * kLabelStep;
        if (inPolygon(stage.mesh, middle, 130)) text.addCentred(label, middle, 200, kLabelColour);
      }
    }
  }
  text.flush(view.toClip, 0);
}

}  // namespace platon
