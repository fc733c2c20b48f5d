#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/scene/camera.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// A face as the camera sees it, in the face's frame. Computed in double, so that large solids do not tremble.
struct FaceView {
  int face = 0;
  glm::mat4 toClip{1};
  glm::vec3 eye{0};
  glm::vec3 light{0, 0, 1};  ///< towards it, unit
};

/// Towards the light, which the camera carries: unit, in space.
glm::dvec3 lightOf(const Camera& camera);

/// The faces whose outside the camera sees.
std::vector<FaceView> visibleFaces(const SolidMesh& mesh, const Camera& camera);

}  // namespace platon
