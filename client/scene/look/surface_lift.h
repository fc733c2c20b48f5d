#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"

namespace platon {

/// Unit vector from a point of the surface to the centre of a ball of `radius` that lies there. It is the normal of the
/// face where the point is farther than the radius from every edge, and turns continuously from one normal to the other
/// over an edge, on which it bisects them.
inline glm::dvec3 liftAt(const SolidMesh& mesh, glm::dvec3 point, double radius) {
  // A face whose plane is `reach` above the point has its edge at a distance of `radius`.
  const double reach = radius * std::sin(mesh.dihedral());
  glm::dvec3 sum(0);
  for (int face = 0; face < mesh.faces(); ++face) {
    const double below = std::max(0.0, mesh.inradius() - glm::dot(mesh.normal(face), point));
    sum += mesh.normal(face) * std::max(0.0, 1 - below / reach);
  }
  return glm::normalize(sum);
}

}  // namespace platon
