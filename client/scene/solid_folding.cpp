#include "client/scene/solid_folding.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/scene/camera_target.h"
#include "levels/drawing/solid_frame.h"

namespace platon {
namespace {

constexpr double kMargin = 1.12;  // round the unfolding, in its size

// From the frame of the face behind an edge to that of `face`, with the edge folded by `angle` radians.
glm::dmat4 overHinge(const SolidMesh& mesh, const Unfolding::Hinge& hinge, double angle) {
  const auto edge = static_cast<std::size_t>(hinge.edge);
  const glm::dvec2 outwards = mesh.edgeNormals()[edge];
  const glm::dvec3 middle(mesh.apothem() * outwards, 0);
  const glm::dvec3 along(-outwards.y, outwards.x, 0);
  const glm::dmat4 fold = glm::rotate(glm::translate(glm::dmat4(1), middle), angle, along);
  return fold * glm::translate(glm::dmat4(1), -middle) * mesh.unfolded(hinge.face, hinge.edge);
}

}  // namespace

std::vector<glm::dmat4> foldedPlaces(const SolidMesh& mesh, int root, double part) {
  std::vector<glm::dmat4> places;
  for (int face = 0; face < mesh.faces(); ++face) places.push_back(mesh.faceToWorld(face));
  if (part >= 1) return places;
  const Unfolding unfolding(mesh);
  const double angle = part * (std::numbers::pi - mesh.dihedral());
  places[static_cast<std::size_t>(unfolding.hinges().front().face)] = glm::dmat4(1);
  for (const Unfolding::Hinge& hinge : unfolding.hinges()) {
    const std::size_t next = mesh.solid().neighbour(hinge.face, hinge.edge).face;
    places[next] = places[static_cast<std::size_t>(hinge.face)] * overHinge(mesh, hinge, angle);
  }
  const glm::dmat4 toSolid = mesh.faceToWorld(root) * glm::inverse(places[static_cast<std::size_t>(root)]);
  for (glm::dmat4& place : places) place = toSolid * place;
  return places;
}

UnfoldingView viewOfUnfolding(const SolidMesh& mesh, const Pose& root, double aspect) {
  UnfoldingView unfolding;
  unfolding.view.orientation = levelOrientation(root.normal, glm::cross(root.up, root.normal));
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high = -low;
  for (const glm::dmat4& place : foldedPlaces(mesh, mesh.faceTowards(root.normal), 0)) {
    for (const glm::dvec2 corner : mesh.polygon()) {
      const glm::dvec3 seen = glm::conjugate(unfolding.view.orientation) * glm::dvec3(place * glm::dvec4(corner, 0, 1));
      low = glm::min(low, seen);
      high = glm::max(high, seen);
      unfolding.reach = std::max(unfolding.reach, glm::length(seen));
    }
  }
  const glm::dvec2 half = glm::dvec2(high - low) / 2.0;
  const double halfView = std::max(half.x / std::max(aspect, 1.0), half.y * std::min(aspect, 1.0));
  const double distance = halfView * kMargin / CameraTarget::kTangent;
  unfolding.view.eye = unfolding.view.orientation * ((low + high) / 2.0 + glm::dvec3(0, 0, distance));
  return unfolding;
}

}  // namespace platon
