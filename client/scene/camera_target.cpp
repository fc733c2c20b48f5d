#include "client/scene/camera_target.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace platon {
namespace {

constexpr double kMinView = 460;  // shorter side of the picture at the player, level units
constexpr double kMaxView = 760;
constexpr double kViewOfFace = 1.3;  // the same in incircle diameters of a face, between the two bounds
constexpr double kZoneOfFace = 0.5;  // largest edge zone in apothems
constexpr double kPartOfRay = 0.35;  // more shows more of the neighbours, and tilts the floors more

double depthBelow(const SolidMesh& mesh, int face, glm::dvec3 place) {
  return mesh.inradius() - glm::dot(mesh.normal(face), place);
}

// From 0 to 1 in the zone at the edge of a neighbouring face, for the depth below its plane.
double nearness(const SolidMesh& mesh, double depth) {
  const double zone = std::min(CameraTarget::kEdgeZone, kZoneOfFace * mesh.apothem());
  return std::clamp(1 - depth / (zone * std::sin(mesh.dihedral())), 0.0, 1.0);
}

// The player's right, at an edge the mean of its directions on both faces. Where two edges are equally near it is that
// on the face itself: so it turns evenly on a way round a corner.
glm::dvec3 rightOf(const Pose& player, const SolidMesh& mesh) {
  int nearest = 0;
  double first = 4 * mesh.circumradius();
  double second = first;
  for (int face = 0; face < mesh.faces(); ++face) {
    if (glm::dot(mesh.normal(face), player.normal) > 1 - 1e-6) continue;
    const double depth = std::max(depthBelow(mesh, face, player.position), 0.0);
    second = std::min(second, std::max(first, depth));
    if (depth >= first) continue;
    first = depth;
    nearest = face;
  }
  const glm::dvec3 right = glm::cross(player.up, player.normal);
  const double part = nearness(mesh, first) * (1 - first / std::max(second, 1e-9));
  return part > 0 ? right + part * rotatedBetween(right, player.normal, mesh.normal(nearest)) : right;
}

}  // namespace

glm::dquat levelOrientation(glm::dvec3 back, glm::dvec3 right) {
  glm::dvec3 seen = right - back * glm::dot(back, right);
  // If `right` is parallel to `back`, any perpendicular direction is used.
  if (glm::length(seen) < 1e-9) seen = glm::cross(glm::dvec3(back.y, back.z, back.x) + glm::dvec3(0.5, 0, 0), back);
  seen = glm::normalize(seen);
  return glm::normalize(glm::quat_cast(glm::dmat3(seen, glm::cross(back, seen), back)));
}

// The depth below the plane of a face is the same function of the place on every face, so the sum has no jump at edges.
glm::dvec3 roundedNormal(const SolidMesh& mesh, glm::dvec3 place) {
  glm::dvec3 sum(0);
  for (int face = 0; face < mesh.faces(); ++face)
    sum += mesh.normal(face) * nearness(mesh, depthBelow(mesh, face, place));
  return glm::normalize(sum);
}

CameraTarget cameraTarget(const Pose& player, const SolidMesh& mesh, double zoom) {
  const glm::dvec3 ray = glm::normalize(player.position);
  const glm::dvec3 back = glm::normalize(glm::mix(roundedNormal(mesh, player.position), ray, kPartOfRay));
  const double view = std::clamp(2 * mesh.apothem() * kViewOfFace, kMinView, kMaxView) / zoom;
  return {levelOrientation(back, rightOf(player, mesh)), view / 2 / CameraTarget::kTangent};
}

}  // namespace platon
