#include "levels/picture/level_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "levels/drawing/level_marks.h"

namespace platon {
namespace {

double distanceTo(const LevelDrawing::Line& line, glm::dvec2 point) {
  const glm::dvec2 along = line.b - line.a;
  const double length = glm::dot(along, along);
  const double share = length > 0 ? std::clamp(glm::dot(point - line.a, along) / length, 0.0, 1.0) : 0;
  return glm::distance(point, line.a + share * along);
}

glm::dvec2 upOf(Angle angle) { return {-std::sin(toRadians(angle)), std::cos(toRadians(angle))}; }

}  // namespace

LevelDrawing::LevelDrawing(const Level& level)
    : solid(level.solid, level.faceSize),
      faces(static_cast<std::size_t>(solid.faces())),
      start{static_cast<int>(level.startFace), toUnits(level.start), upOf(level.startAngle)},
      goal{static_cast<int>(level.goalFace), toUnits(level.goal)} {
  for (int face = 0; face < solid.faces(); ++face) addSegments(level, face);
  addArrows(level);
  for (int face = 0; face < solid.faces(); ++face) addLabel(face);
}

void LevelDrawing::addSegments(const Level& level, int face) {
  const auto& segments = level.segments[static_cast<std::size_t>(face)];
  for (std::uint32_t index = 0; index < segments.size(); ++index) {
    Line line{toUnits(segments[index].a), toUnits(segments[index].b), {}};
    const Element* element = findElement(level.elements, static_cast<std::uint32_t>(face), index);
    if (element != nullptr) line.element = styleOf(*element);
    faces[static_cast<std::size_t>(face)].lines.push_back(line);
    addAlongEdges(face, line);
  }
}

ElementStyle LevelDrawing::styleOf(const Element& element) const {
  ElementStyle style{element.kind, element.number, {0, 1}};
  if (traitsOf(element.kind).number == ElementNumber::kEdge) style.towards = solid.edgeNormals()[element.number];
  return style;
}

// A segment along an edge belongs to both faces, which need not be neighbours in the unfolding or in the same view.
void LevelDrawing::addAlongEdges(int face, const Line& line) {
  const std::vector<glm::dvec2>& normals = solid.edgeNormals();
  for (std::size_t edge = 0; edge < normals.size(); ++edge) {
    const double nearest = std::min(glm::dot(line.a, normals[edge]), glm::dot(line.b, normals[edge]));
    if (nearest < solid.apothem() - LevelMarks::kSegmentWidth / 2) continue;
    const auto index = static_cast<int>(edge);
    const glm::dmat4 toNeighbour = glm::inverse(solid.unfolded(face, index));
    Line moved = line;
    for (glm::dvec2* end : {&moved.a, &moved.b}) *end = glm::dvec2(toNeighbour * glm::dvec4(*end, 0, 1));
    if (moved.element) moved.element->towards = glm::dvec2(toNeighbour * glm::dvec4(line.element->towards, 0, 0));
    faces[solid.solid().neighbour(face, index).face].lines.push_back(moved);
  }
}

void LevelDrawing::addArrows(const Level& level) {
  for (int edge = 0; edge < solid.solid().edgesPerFace(); ++edge) {
    const PlatonicSolid::Neighbour& next = solid.solid().neighbour(start.face, edge);
    const glm::dvec2 middle = 0.55 * solid.apothem() * solid.edgeNormals()[next.edge];
    const glm::dvec2 half = -0.2 * solid.apothem() * upOf(level.startAngle + next.turn);
    faces[next.face].down = {middle - half, middle + half};
  }
}

void LevelDrawing::addLabel(int face) {
  Face& drawn = faces[static_cast<std::size_t>(face)];
  const double edge = solid.faceSize();
  drawn.label = {faceLabel(face), {0, 0}, (solid.solid().edgesPerFace() == 5 ? 0.12 : 0.085) * edge};
  const double depth = solid.solid().edgesPerFace() == 4 ? 0.12 * edge : 0.18 * edge;
  double most = -1;
  for (const glm::dvec2 corner : solid.polygon()) {
    const glm::dvec2 middle = corner - depth * glm::normalize(corner);
    double room = drawn.label.size;
    for (const Line& line : drawn.lines) room = std::min(room, distanceTo(line, middle));
    if (room <= most) continue;
    most = room;
    drawn.label.middle = middle;
  }
}

std::set<ElementKind> LevelDrawing::kinds() const {
  std::set<ElementKind> kinds;
  for (const Face& face : faces) {
    for (const Line& line : face.lines) {
      if (line.element) kinds.insert(line.element->kind);
    }
  }
  return kinds;
}

}  // namespace platon
