#include "client/gl/stage_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/gl/face_program.h"
#include "client/gl/shaders.h"

namespace platon {
namespace {

constexpr float kShadowReach = 8;  // width of a segment's shadow, level units
constexpr float kGridStep = 60;
constexpr float kLargeFace = 700;  // apothem from which a face has several numbers
constexpr float kLabelStep = 640;
constexpr float kGoalReach = 4;  // radius of the goal's glow in goal radii
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

StagePainter::StagePainter()
    : face_(shaders::kFaceGeometry, shaders::kFaceVertex, shaders::kFaceFragment),
      ribbon_(shaders::kFaceGeometry, shaders::kRibbonVertex, std::string(shaders::kInk) + shaders::kRibbonFragment),
      marker_(shaders::kFaceGeometry, shaders::kMarkerVertex, std::string(shaders::kInk) + shaders::kMarkerFragment),
      mark_(shaders::kFaceGeometry, shaders::kMarkVertex, std::string(shaders::kInk) + shaders::kMarkFragment) {
  glBindVertexArray(faceArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(ribbonArray_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribDivisor(0, 1);
}

void StagePainter::draw(const std::shared_ptr<const StageModel>& stage, std::span<const FaceView> views) {
  if (loaded_.lock() != stage) load(*stage);
  loaded_ = stage;
  glBindVertexArray(faceArray_.name());
  for (const FaceView& view : views) {
    useOnFace(face_, *stage, view);
    face_.set("colour", stage->faces[static_cast<std::size_t>(view.face)].colour);
    face_.set("eye", view.eye);
    face_.set("light", view.light);
    face_.set("gridStep", kGridStep);
    glDrawArrays(GL_TRIANGLE_FAN, 0, static_cast<GLsizei>(stage->mesh.polygon().size()));
  }
}

void StagePainter::drawOnFaces(const Scene& scene, std::span<const FaceView> views, float seconds, TextPainter& text) {
  for (const FaceView& view : views) {
    drawLabels(*scene.stage, view, text);
    drawMarks(scene, view, scene.marksBelow, marksBelow_);
    drawRibbons(*scene.stage, view, true);
    drawMarkers(scene, view, seconds);
    elementPainter_.draw(scene, view, text);
    drawRibbons(*scene.stage, view, false);
    drawMarks(scene, view, scene.marksAbove, marksAbove_);
    drawShadows(scene, view);
  }
}

void StagePainter::load(const StageModel& stage) {
  std::vector<glm::vec2> corners(stage.mesh.polygon().begin(), stage.mesh.polygon().end());
  fill(corners_, corners);
  std::vector<Ribbon> ends;
  ribbons_.clear();
  for (const FaceDrawing& face : stage.faces) {
    ribbons_.push_back({static_cast<GLsizei>(ends.size()), static_cast<GLsizei>(face.ribbons.size())});
    ends.insert(ends.end(), face.ribbons.begin(), face.ribbons.end());
  }
  fill(ends_, ends);
}

void StagePainter::drawRibbons(const StageModel& stage, const FaceView& view, bool shadow) {
  const Ribbons& ribbons = ribbons_[static_cast<std::size_t>(view.face)];
  if (ribbons.count == 0) return;
  useOnFace(ribbon_, stage, view);
  ribbon_.set("light", view.light);
  ribbon_.set("halfWidth", static_cast<float>(StageModel::kRibbonWidth / 2));
  ribbon_.set("reach", static_cast<float>(StageModel::kRibbonWidth / 2) + kShadowReach);
  ribbon_.set("shadow", shadow ? 1.0F : 0.0F);
  glBindVertexArray(ribbonArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, ends_.name());
  const auto offset = static_cast<std::size_t>(ribbons.first) * sizeof(Ribbon);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Ribbon), bufferOffset(offset));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, ribbons.count);
}

void StagePainter::drawMarks(const Scene& scene, const FaceView& view, const FaceMarks& marks, Marks& kept) {
  if (marks == nullptr || marks->empty()) return;
  if (kept.loaded != marks) load(*scene.stage, marks, kept);
  const Ribbons& part = kept.parts[static_cast<std::size_t>(view.face)];
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
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, part.count);
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

void StagePainter::drawMarkers(const Scene& scene, const FaceView& view, float seconds) {
  const StageModel& stage = *scene.stage;
  useOnFace(marker_, stage, view);
  marker_.set("seconds", seconds);
  glBindVertexArray(markerArray_.name());
  constexpr auto kStartRadius = static_cast<float>(StageModel::kPlayerRadius * 1.6);
  constexpr auto goalRadius = static_cast<float>(StageModel::kGoalRadius);
  drawMarker(stage.mesh, view, stage.start, {1, kStartRadius, kStartRadius * 1.2F});
  drawMarker(stage.mesh, view, stage.goal, {0, goalRadius, goalRadius * kGoalReach});
}

void StagePainter::drawMarker(const SolidMesh& mesh, const FaceView& view, const Marker& marker, const Look& look) {
  const auto here = markerOn(mesh, view.face, marker, double{look.reach});
  if (!here) return;
  marker_.set("kind", look.kind);
  marker_.set("centre", here->place);
  marker_.set("angle", static_cast<float>(here->angle));
  marker_.set("radius", look.radius);
  marker_.set("reach", look.reach);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void StagePainter::drawShadows(const Scene& scene, const FaceView& view) {
  const SolidMesh& mesh = scene.stage->mesh;
  useOnFace(marker_, *scene.stage, view);
  glBindVertexArray(markerArray_.name());
  constexpr auto kRadius = static_cast<float>(StageModel::kPlayerRadius);
  for (const PlayerDrawing& player : scene.players) {
    const int face = mesh.faceTowards(player.pose.position);
    const glm::dvec4 place = glm::inverse(mesh.faceToWorld(face)) * glm::dvec4(player.pose.position, 1);
    drawMarker(mesh, view, {face, glm::vec2(place), 0}, {2, kRadius, kRadius * 1.6F});
  }
}

void StagePainter::drawLabels(const StageModel& stage, const FaceView& view, TextPainter& text) const {
  const std::string& label = stage.faces[static_cast<std::size_t>(view.face)].label;
  const auto apothem = static_cast<float>(stage.mesh.apothem());
  if (apothem < kLargeFace) {
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
