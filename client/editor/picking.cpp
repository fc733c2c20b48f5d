#include "client/editor/picking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/ui/overlay.h"

namespace platon {
namespace {

glm::dvec3 divided(glm::dvec4 point) { return glm::dvec3(point) / point.w; }

// Part of the way from `a` to `b` that is nearest to the place, 0 … 1.
double partOf(const EditedSegment& segment, glm::dvec2 place) {
  const glm::dvec2 way = segment.b - segment.a;
  const double square = glm::dot(way, way);
  return square > 0 ? std::clamp(glm::dot(place - segment.a, way) / square, 0.0, 1.0) : 0;
}

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

double upOfPicture(const SolidMesh& mesh, int face, const Camera& camera) {
  const glm::dvec2 up(glm::inverse(mesh.faceToWorld(face)) * glm::dvec4(camera.up(), 0));
  return std::atan2(-up.x, up.y) * 180 / std::numbers::pi;
}

std::optional<PickedSegment> pickSegment(std::span<const EditedSegment> segments, const FacePlace& pointer,
                                         double reach) {
  std::optional<PickedSegment> best;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const EditedSegment& segment = segments[i];
    if (segment.face != pointer.face) continue;
    const double part = partOf(segment, pointer.place);
    const double distance = glm::distance(glm::mix(segment.a, segment.b, part), pointer.place);
    if (distance > reach) continue;
    reach = distance;
    best = PickedSegment{i, PickedSegment::Part::kWhole};
  }
  if (!best) return best;
  const EditedSegment& segment = segments[best->segment];
  const double part = partOf(segment, pointer.place);
  if (part < 1.0 / 3) best->part = PickedSegment::Part::kFirstEnd;
  if (part > 2.0 / 3) best->part = PickedSegment::Part::kSecondEnd;
  return best;
}

}  // namespace platon
