#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/scene/camera.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// Camera and light in the frame of a visible face. Computed in double precision, so that large solids do not jitter.
struct FaceView {
  int face = 0;
  glm::mat4 toClip{1};
  glm::vec3 eye{0};
  glm::vec3 light{0, 0, 1};  ///< unit vector towards the light
};

/// Unit vector towards the light, in space. The light moves with the camera.
glm::dvec3 lightOf(const Camera& camera);

/// The faces whose outer side faces the camera.
std::vector<FaceView> visibleFaces(const SolidMesh& mesh, const Camera& camera);

/// All faces, when they are not in the solid but at these places: transforms from their frames to space.
std::vector<FaceView> facesAt(std::span<const glm::dmat4> places, const Camera& camera);

/// The other faces on which something that stands up from them can be seen past the edges of the visible faces.
std::vector<FaceView> facesBeyondTheHorizon(const SolidMesh& mesh, const Camera& camera);

/// Unit vector towards the light of a face, in its frame. The light does not move, so that shadows can be computed
/// once. It comes from one side of the solid, but on every face at least 50 degrees above the horizon: no face is dark.
glm::dvec3 faceLight(const SolidMesh& mesh, int face);

}  // namespace platon
