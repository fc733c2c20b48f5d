#include "client/scene/solid_mesh.h"

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

}  // namespace platon
