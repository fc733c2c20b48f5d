#include "client/scene/solid_mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace platon {

Pose SolidMesh::pose(int face, glm::dvec2 point, double angle) const {
  const glm::dvec4 up(-std::sin(angle), std::cos(angle), 0, 0);
  return {toWorld(face, point), glm::dvec3(faceToWorld(face) * up), normal(face)};
}

int SolidMesh::faceTowards(glm::dvec3 point) const {
  int best = 0;
  for (int face = 1; face < faces(); ++face) {
    if (glm::dot(normal(face), point) > glm::dot(normal(best), point)) best = face;
  }
  return best;
}

glm::dvec3 SolidMesh::onSurface(glm::dvec3 point) const {
  return point * (inradius() / glm::dot(normal(faceTowards(point)), point));
}

bool SolidMesh::isBetween(glm::dvec3 a, glm::dvec3 b) const {
  double enter = 0;
  double leave = 1;
  for (int face = 0; face < faces(); ++face) {
    const double heightOfA = glm::dot(normal(face), a) - inradius();
    const double heightOfB = glm::dot(normal(face), b) - inradius();
    if (heightOfA > 0 && heightOfB > 0) return false;
    if (heightOfA > 0) enter = std::max(enter, heightOfA / (heightOfA - heightOfB));
    if (heightOfB > 0) leave = std::min(leave, heightOfA / (heightOfA - heightOfB));
  }
  return enter < leave - 1e-9;
}

}  // namespace platon
