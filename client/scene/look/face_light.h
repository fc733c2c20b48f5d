#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"

namespace platon {

/// Unit vector towards the light of a face, in its frame. The light does not move, so that shadows can be computed
/// once. It comes from one side of the solid, but on every face at least 50 degrees above the horizon: no face is dark.
inline glm::dvec3 faceLight(const SolidMesh& mesh, int face) {
  const glm::dvec3 sun(-0.48, 0.75, 0.46);
  const glm::dvec3 seen = glm::inverse(glm::dmat3(mesh.faceToWorld(face))) * sun;
  return glm::normalize(glm::dvec3(0.8 * seen.x, 0.8 * seen.y, 1));
}

}  // namespace platon
