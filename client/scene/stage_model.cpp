#include "client/scene/stage_model.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

// A ribbon that lies along an edge is drawn on both faces: each clips it at the edge.
void addOverEdges(StageModel& stage, int face, glm::dvec2 a, glm::dvec2 b) {
  const std::vector<glm::dvec2>& normals = stage.mesh.edgeNormals();
  for (std::size_t edge = 0; edge < normals.size(); ++edge) {
    const double reach = std::max(glm::dot(a, normals[edge]), glm::dot(b, normals[edge]));
    if (reach < stage.mesh.apothem() - StageModel::kRibbonWidth / 2) continue;
    const int index = static_cast<int>(edge);
    const glm::dmat4 toNeighbour = glm::inverse(stage.mesh.unfolded(face, index));
    const auto moved = [&](glm::dvec2 point) { return glm::vec2(toNeighbour * glm::dvec4(point, 0, 1)); };
    const std::size_t next = stage.mesh.solid().neighbour(face, index).face;
    stage.faces[next].ribbons.push_back({moved(a), moved(b)});
  }
}

void addRibbons(StageModel& stage, const Level& level, int face) {
  for (const Segment& segment : level.segments[static_cast<std::size_t>(face)]) {
    const glm::dvec2 a = toUnits(segment.a);
    const glm::dvec2 b = toUnits(segment.b);
    stage.faces[static_cast<std::size_t>(face)].ribbons.push_back({a, b});
    addOverEdges(stage, face, a, b);
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
  for (int face = 0; face < stage->mesh.faces(); ++face)
    stage->faces.push_back({faceColour(face), faceLabel(face), {}});
  for (int face = 0; face < stage->mesh.faces(); ++face) addRibbons(*stage, level, face);
  stage->goal = {static_cast<int>(level.goalFace), toUnits(level.goal), 0};
  stage->start = {static_cast<int>(level.startFace), toUnits(level.start), toRadians(level.startAngle)};
  return stage;
}

}  // namespace platon
