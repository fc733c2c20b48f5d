#include "client/scene/pose_between.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace platon {
namespace {

// Longest interpolated distance in one tick, level units: the fastest fall is 12, and slopes and jumps can add to it.
// A shorter jump is interpolated, too; that lasts one tick.
constexpr double kMaxTickDistance = 32;

struct FacePoint {
  int face = 0;
  glm::dvec2 point{0, 0};
};

FacePoint placeOf(const PlayerSnapshot& player) { return {static_cast<int>(player.part), toUnits(player.position)}; }

glm::dvec2 moved(const glm::dmat4& frame, glm::dvec2 point) { return glm::dvec2(frame * glm::dvec4(point, 0, 1)); }

// Interpolates over one edge. Returns nothing if the straight path does not cross this edge.
std::optional<FacePoint> overEdge(const SolidMesh& mesh, FacePoint before, int edge, FacePoint now, double fraction) {
  const glm::dmat4 unfolded = mesh.unfolded(before.face, edge);
  const glm::dvec2 outwards = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
  const glm::dvec2 path = moved(unfolded, now.point) - before.point;
  const double inside = mesh.apothem() - glm::dot(outwards, before.point);
  const double across = glm::dot(outwards, path);
  if (inside < 0 || across <= inside) return std::nullopt;
  const glm::dvec2 crossing = before.point + path * (inside / across);
  if (std::abs(glm::dot(glm::dvec2(-outwards.y, outwards.x), crossing)) > mesh.faceSize() / 2) return std::nullopt;
  const glm::dvec2 flat = before.point + path * fraction;
  if (across * fraction <= inside) return FacePoint{before.face, flat};
  return FacePoint{now.face, moved(glm::inverse(unfolded), flat)};
}

std::optional<FacePoint> alongSurface(const SolidMesh& mesh, FacePoint before, FacePoint now, double fraction) {
  if (before.face == now.face) return FacePoint{now.face, glm::mix(before.point, now.point, fraction)};
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    if (mesh.solid().neighbour(before.face, edge).face != now.face) continue;
    return overEdge(mesh, before, edge, now, fraction);
  }
  return std::nullopt;
}

glm::dvec3 upBetween(const Pose& before, const Pose& now, glm::dvec3 normal, double fraction) {
  const glm::dvec3 last = rotatedBetween(now.up, now.normal, normal);
  const glm::dvec3 up = glm::mix(rotatedBetween(before.up, before.normal, normal), last, fraction);
  return glm::normalize(glm::length(up) > 1e-6 ? up : last);
}

}  // namespace

Pose poseOf(const SolidMesh& mesh, const PlayerSnapshot& player) {
  return mesh.pose(static_cast<int>(player.part), toUnits(player.position), toRadians(player.angle));
}

Pose poseBetween(const SolidMesh& mesh, const InterpolatedPlayer& player) {
  const Pose before = poseOf(mesh, player.before);
  const Pose now = poseOf(mesh, player.now);
  if (glm::distance(before.position, now.position) > kMaxTickDistance) return now;
  const auto place = alongSurface(mesh, placeOf(player.before), placeOf(player.now), player.fraction);
  const glm::dvec3 position = place ? mesh.toWorld(place->face, place->point)
                                    : mesh.onSurface(glm::mix(before.position, now.position, player.fraction));
  const glm::dvec3 normal = mesh.normal(place ? place->face : mesh.faceTowards(position));
  return {position, upBetween(before, now, normal, player.fraction), normal};
}

}  // namespace platon
