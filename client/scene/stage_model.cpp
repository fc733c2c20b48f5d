#include "client/scene/stage_model.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

// Calls `add(face, toFace)` for `face` and for each neighbour over whose edge a segment reaches: it is drawn on both
// faces, and each clips it at the edge. `toFace` maps a point or a direction from the frame of `face`.
template <class Add>
void onItsFaces(const StageModel& stage, int face, const Ribbon& ends, Add add) {
  add(static_cast<std::size_t>(face), glm::dmat4(1));
  const std::vector<glm::dvec2>& normals = stage.mesh.edgeNormals();
  for (std::size_t edge = 0; edge < normals.size(); ++edge) {
    const double reach =
        std::max(glm::dot(glm::dvec2(ends.a), normals[edge]), glm::dot(glm::dvec2(ends.b), normals[edge]));
    if (reach < stage.mesh.apothem() - StageModel::kRibbonWidth / 2) continue;
    const int index = static_cast<int>(edge);
    const std::size_t next = stage.mesh.solid().neighbour(face, index).face;
    add(next, glm::inverse(stage.mesh.unfolded(face, index)));
  }
}

glm::vec2 mapped(const glm::dmat4& map, glm::vec2 vector, double w) {
  return glm::vec2(map * glm::dvec4(vector, 0, w));
}

Ribbon mapped(const glm::dmat4& map, const Ribbon& ends) { return {mapped(map, ends.a, 1), mapped(map, ends.b, 1)}; }

ElementDrawing drawingOf(const StageModel& stage, const Element& element, std::size_t index) {
  ElementDrawing drawing{
      {toUnits(element.ends.a), toUnits(element.ends.b)}, element.kind, element.number, {0, 1}, {}, true};
  if (traitsOf(element.kind).number == ElementNumber::kEdge) drawing.towards = stage.mesh.edgeNormals()[element.number];
  drawing.element = static_cast<std::uint32_t>(index);
  return drawing;
}

void addRibbons(StageModel& stage, const Level& level, int face) {
  const std::vector<Segment>& segments = level.segments[static_cast<std::size_t>(face)];
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (findElement(level.elements, static_cast<std::uint32_t>(face), i) != nullptr) continue;
    const Ribbon ends{toUnits(segments[i].a), toUnits(segments[i].b)};
    onItsFaces(stage, face, ends, [&](std::size_t on, const glm::dmat4& toFace) {
      stage.faces[on].ribbons.push_back(mapped(toFace, ends));
    });
  }
}

void addElements(StageModel& stage, const Level& level) {
  for (std::size_t i = 0; i < level.elements.size(); ++i) {
    const ElementDrawing drawing = drawingOf(stage, level.elements[i], i);
    const auto face = static_cast<int>(level.elements[i].face);
    onItsFaces(stage, face, drawing.ends, [&](std::size_t on, const glm::dmat4& toFace) {
      ElementDrawing there = drawing;
      there.ends = mapped(toFace, drawing.ends);
      there.towards = mapped(toFace, drawing.towards, 0);
      there.own = on == static_cast<std::size_t>(face);
      stage.faces[on].elements.push_back(there);
    });
  }
}

}  // namespace

std::optional<Marker> markerOn(const SolidMesh& mesh, int face, const Marker& marker, double reach) {
  if (marker.face == face) return marker;
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(face, edge);
    if (next.face != marker.face) continue;
    const glm::dvec2 place(mesh.unfolded(face, edge) * glm::dvec4(marker.place, 0, 1));
    const double beyond = glm::dot(place, mesh.edgeNormals()[static_cast<std::size_t>(edge)]) - mesh.apothem();
    if (beyond < reach) return Marker{face, place, marker.angle - toRadians(next.turn)};
  }
  return std::nullopt;
}

std::shared_ptr<const StageModel> makeStageModel(const Level& level) {
  auto stage =
      std::make_shared<StageModel>(StageModel{SolidMesh(level.solid, level.faceSize), {}, {}, {}, level.title});
  const std::vector<int>& tones = tonesOfFaces(level.solid);
  for (int face = 0; face < stage->mesh.faces(); ++face) {
    const auto tone = static_cast<std::size_t>(tones[static_cast<std::size_t>(face)]);
    stage->faces.push_back({stage->scheme().tones[tone], faceLabel(face)});
  }
  for (int face = 0; face < stage->mesh.faces(); ++face) addRibbons(*stage, level, face);
  addElements(*stage, level);
  stage->goal = {static_cast<int>(level.goalFace), toUnits(level.goal), 0};
  stage->start = {static_cast<int>(level.startFace), toUnits(level.start), toRadians(level.startAngle)};
  return stage;
}

namespace {

constexpr int kRings = 5;  // numbers of corners

double distanceTo(const Ribbon& ends, glm::dvec2 point) {
  const glm::dvec2 a(ends.a);
  const glm::dvec2 way = glm::dvec2(ends.b) - a;
  const double share = glm::clamp(glm::dot(point - a, way) / std::max(glm::dot(way, way), 1e-9), 0.0, 1.0);
  return glm::distance(point, a + way * share);
}

// The distance from `point` to what else is on the face.
double clearance(const StageModel& stage, int face, glm::dvec2 point) {
  const FaceDrawing& drawing = stage.faces[static_cast<std::size_t>(face)];
  double nearest = std::numeric_limits<double>::max();
  for (const Ribbon& ends : drawing.ribbons) nearest = std::min(nearest, distanceTo(ends, point));
  for (const ElementDrawing& element : drawing.elements) nearest = std::min(nearest, distanceTo(element.ends, point));
  for (const Marker& marker : {stage.goal, stage.start}) {
    if (marker.face == face) nearest = std::min(nearest, glm::distance(glm::dvec2(marker.place), point));
  }
  return nearest;
}

glm::dvec2 placeOf(const StageModel& stage, int face, double radius) {
  glm::dvec2 best(0);
  double most = std::min(clearance(stage, face, best), 3 * radius);
  for (const double share : {0.3, 0.5, 0.66}) {
    for (const glm::dvec2 corner : stage.mesh.polygon()) {
      const double room = std::min(clearance(stage, face, share * corner), 3 * radius);
      if (room <= most + 1e-6) continue;
      most = room;
      best = share * corner;
    }
  }
  return best;
}

}  // namespace

std::vector<FaceSign> signsOf(const StageModel& stage) {
  std::vector<FaceSign> signs;
  const double radius = std::clamp(0.12 * stage.mesh.apothem(), 14.0, 80.0);
  for (int face = 0; face < stage.mesh.faces(); ++face) {
    signs.push_back(
        {glm::vec2(placeOf(stage, face, radius)), static_cast<float>(radius), 3 + face % kRings, 1 + face / kRings});
  }
  return signs;
}

}  // namespace platon
