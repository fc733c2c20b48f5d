#include "client/editor/face_picker.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/ui/overlay.h"

namespace platon {
namespace {

glm::dvec3 divided(glm::dvec4 point) { return glm::dvec3(point) / point.w; }

}  // namespace

std::optional<FacePlace> pickFace(const SolidMesh& mesh, const Camera& camera, glm::dvec2 screen) {
  const double width = double{Overlay::kHeight} * camera.width() / camera.height();
  const glm::dvec2 clip(screen.x / width * 2 - 1, 1 - screen.y / Overlay::kHeight * 2);
  const glm::dvec3 beyond = divided(glm::inverse(camera.viewProjection()) * glm::dvec4(clip, 0.5, 1));
  const glm::dvec3 eye = camera.eye();
  const glm::dvec3 ray = glm::normalize(beyond - eye);
  for (int face = 0; face < mesh.faces(); ++face) {
    const double towards = glm::dot(ray, mesh.normal(face));
    if (towards > -1e-9) continue;
    const glm::dvec3 point = eye + ray * ((mesh.inradius() - glm::dot(eye, mesh.normal(face))) / towards);
    const glm::dvec2 place(glm::inverse(mesh.faceToWorld(face)) * glm::dvec4(point, 1));
    const bool inside = std::all_of(mesh.edgeNormals().begin(), mesh.edgeNormals().end(), [&](glm::dvec2 normal) {
      return glm::dot(normal, place) <= mesh.apothem() * (1 + 1e-9);
    });
    if (inside) return FacePlace{face, place};
  }
  return std::nullopt;
}

double screenScale(const SolidMesh& mesh, const Camera& camera, const FacePlace& at) {
  const glm::dvec3 point = mesh.toWorld(at.face, at.place);
  const auto heightOf = [&](glm::dvec3 place) {
    return divided(camera.viewProjection() * glm::dvec4(place, 1)).y * Overlay::kHeight / 2;
  };
  return heightOf(point + camera.up()) - heightOf(point);
}

}  // namespace platon
