#include "client/scene/look/edge_way.h"

#include <algorithm>
#include <cstddef>

namespace platon {
namespace {

double side(glm::dvec2 from, glm::dvec2 to, glm::dvec2 point) {
  const glm::dvec2 way = to - from;
  const glm::dvec2 aside = point - from;
  return way.x * aside.y - way.y * aside.x;
}

bool cross(const Ribbon& ends, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 a(ends.a);
  const glm::dvec2 b(ends.b);
  return side(from, to, a) * side(from, to, b) <= 0 && side(a, b, from) * side(a, b, to) < 0;
}

bool blocks(const ElementDrawing& drawing, const ElementStates& states) {
  switch (drawing.kind) {
    case ElementKind::kPlate:
      return true;
    case ElementKind::kDoor:
    case ElementKind::kUp:
      return drawing.element < states.active.size() && states.active[drawing.element] != 0;
    case ElementKind::kOneway:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
    case ElementKind::kKey:
      return false;
  }
  return false;
}

}  // namespace

bool wayIsFree(const StageModel& stage, const ElementStates& states, int face, glm::dvec2 from, glm::dvec2 to) {
  const FaceDrawing& drawing = stage.faces[static_cast<std::size_t>(face)];
  const auto isAcross = [&](const Ribbon& ends) { return cross(ends, from, to); };
  return std::none_of(drawing.ribbons.begin(), drawing.ribbons.end(), isAcross) &&
         std::none_of(drawing.elements.begin(), drawing.elements.end(),
                      [&](const ElementDrawing& element) { return blocks(element, states) && isAcross(element.ends); });
}

}  // namespace platon
