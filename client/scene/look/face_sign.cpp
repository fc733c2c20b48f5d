#include "client/scene/look/face_sign.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
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
