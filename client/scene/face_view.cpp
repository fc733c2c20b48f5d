#include "client/scene/face_view.h"

#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace platon {

glm::dvec3 lightOf(const Camera& camera) {
  return glm::normalize(-0.45 * camera.right() + 0.65 * camera.up() + 0.75 * camera.back());
}

namespace {

bool isVisible(const SolidMesh& mesh, const Camera& camera, int face) {
  return glm::dot(mesh.normal(face), camera.eye()) > mesh.inradius();
}

// What the views of all faces share.
struct Frame {
  explicit Frame(const Camera& camera) : toClip(camera.viewProjection()), light(lightOf(camera)) {}

  glm::dmat4 toClip;
  glm::dvec3 light;
};

FaceView viewOf(int face, const glm::dmat4& toWorld, const Camera& camera, const Frame& frame) {
  const glm::dmat4 toFace = glm::inverse(toWorld);
  return {face, glm::mat4(frame.toClip * toWorld), glm::vec3(toFace * glm::dvec4(camera.eye(), 1)),
          glm::vec3(toFace * glm::dvec4(frame.light, 0))};
}

// The views of the faces for which `matches` returns true.
template <class Matches>
std::vector<FaceView> viewsOf(const SolidMesh& mesh, const Camera& camera, Matches matches) {
  std::vector<FaceView> views;
  const Frame frame(camera);
  for (int face = 0; face < mesh.faces(); ++face) {
    if (matches(face)) views.push_back(viewOf(face, mesh.faceToWorld(face), camera, frame));
  }
  return views;
}

}  // namespace

std::vector<FaceView> visibleFaces(const SolidMesh& mesh, const Camera& camera) {
  return viewsOf(mesh, camera, [&](int face) { return isVisible(mesh, camera, face); });
}

std::vector<FaceView> facesAt(std::span<const glm::dmat4> places, const Camera& camera) {
  std::vector<FaceView> views;
  const Frame frame(camera);
  for (std::size_t face = 0; face < places.size(); ++face)
    views.push_back(viewOf(static_cast<int>(face), places[face], camera, frame));
  return views;
}

std::vector<FaceView> facesBeyondTheHorizon(const SolidMesh& mesh, const Camera& camera) {
  constexpr double kOppositeSide = -0.6;  // the cosine to the line of sight
  return viewsOf(mesh, camera, [&](int face) {
    return !isVisible(mesh, camera, face) && glm::dot(mesh.normal(face), camera.back()) > kOppositeSide;
  });
}

glm::dvec3 faceLight(const SolidMesh& mesh, int face) {
  const glm::dvec3 sun(-0.48, 0.75, 0.46);
  const glm::dvec3 seen = glm::inverse(glm::dmat3(mesh.faceToWorld(face))) * sun;
  return glm::normalize(glm::dvec3(0.8 * seen.x, 0.8 * seen.y, 1));
}

}  // namespace platon
