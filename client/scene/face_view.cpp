#include "client/scene/face_view.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace platon {

glm::dvec3 lightOf(const Camera& camera) {
  return glm::normalize(-0.45 * camera.right() + 0.65 * camera.up() + 0.75 * camera.back());
}

namespace {

bool isVisible(const SolidMesh& mesh, const Camera& camera, int face) {
  return glm::dot(mesh.normal(face), camera.eye()) > mesh.inradius();
}

// The views of the faces for which `matches` returns true.
template <class Matches>
std::vector<FaceView> viewsOf(const SolidMesh& mesh, const Camera& camera, Matches matches) {
  std::vector<FaceView> views;
  const glm::dmat4 toClip = camera.viewProjection();
  const glm::dvec3 light = lightOf(camera);
  for (int face = 0; face < mesh.faces(); ++face) {
    if (!matches(face)) continue;
    const glm::dmat4& toWorld = mesh.faceToWorld(face);
    const glm::dmat4 toFace = glm::inverse(toWorld);
    views.push_back({face, glm::mat4(toClip * toWorld), glm::vec3(toFace * glm::dvec4(camera.eye(), 1)),
                     glm::vec3(toFace * glm::dvec4(light, 0))});
  }
  return views;
}

}  // namespace

std::vector<FaceView> visibleFaces(const SolidMesh& mesh, const Camera& camera) {
  return viewsOf(mesh, camera, [&](int face) { return isVisible(mesh, camera, face); });
}

std::vector<FaceView> facesBeyondTheHorizon(const SolidMesh& mesh, const Camera& camera) {
  constexpr double kOppositeSide = -0.6;  // the cosine to the line of sight
  return viewsOf(mesh, camera, [&](int face) {
    return !isVisible(mesh, camera, face) && glm::dot(mesh.normal(face), camera.back()) > kOppositeSide;
  });
}

}  // namespace platon
