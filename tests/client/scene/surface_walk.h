#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "client/scene/solid_mesh.h"

namespace platon {

/// A place on a solid that moves along the surface as a player does: its frame is carried over the edges.
struct SurfaceWalk {
  const SolidMesh* mesh = nullptr;
  int face = 0;
  glm::dvec2 place{0};  ///< in the frame of the face
  double angle = 0;     ///< of its up from the face's +y, radians counter-clockwise

  Pose pose() const { return mesh->pose(face, place, angle); }

  /// Distance from the nearest edge.
  double depth() const {
    double nearest = mesh->circumradius();
    for (const glm::dvec2 normal : mesh->edgeNormals())
      nearest = std::min(nearest, mesh->apothem() - glm::dot(normal, place));
    return nearest;
  }

  /// Moves to its right and along its up, level units. A step crosses few edges.
  void step(glm::dvec2 way) {
    const glm::dvec2 up(-std::sin(angle), std::cos(angle));
    place += way.x * glm::dvec2(up.y, -up.x) + way.y * up;
    for (int crossings = 0; crossings < 4 && depth() < 0; ++crossings) cross(outermost());
  }

 private:
  int outermost() const {
    int best = 0;
    const auto beyond = [this](int edge) {
      return glm::dot(mesh->edgeNormals()[static_cast<std::size_t>(edge)], place);
    };
    for (int edge = 1; edge < mesh->solid().edgesPerFace(); ++edge) best = beyond(edge) > beyond(best) ? edge : best;
    return best;
  }

  void cross(int edge) {
    const PlatonicSolid::Neighbour& next = mesh->solid().neighbour(face, edge);
    place = glm::dvec2(glm::inverse(mesh->unfolded(face, edge)) * glm::dvec4(place, 0, 1));
    angle += toRadians(next.turn);
    face = static_cast<int>(next.face);
  }
};

}  // namespace platon
