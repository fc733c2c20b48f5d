#include "client/editor/snapping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

glm::dvec2 onGrid(glm::dvec2 place, double grid) {
  return {std::round(place.x / grid) * grid, std::round(place.y / grid) * grid};
}

glm::dvec2 nearestOn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 place) {
  const glm::dvec2 way = b - a;
  const double square = glm::dot(way, way);
  return square > 0 ? a + way * std::clamp(glm::dot(place - a, way) / square, 0.0, 1.0) : a;
}

// Keeps the nearest of the places that are within reach.
struct Nearest {
  glm::dvec2 pointer;
  double reach;
  std::optional<glm::dvec2> place{};

  void offer(glm::dvec2 candidate, glm::dvec2 measured) {
    const double distance = glm::distance(measured, pointer);
    if (distance >= reach) return;
    reach = distance;
    place = candidate;
  }
};

bool isOnFace(const SolidMesh& mesh, glm::dvec2 place) {
  return std::all_of(mesh.edgeNormals().begin(), mesh.edgeNormals().end(),
                     [&](glm::dvec2 normal) { return glm::dot(normal, place) <= mesh.apothem() + 1e-6; });
}

// The segments on the face and, unfolded, on its neighbours.
std::vector<EditedSegment> segmentsNear(const SolidMesh& mesh, std::span<const EditedSegment> segments, int face) {
  std::vector<std::optional<glm::dmat4>> maps(static_cast<std::size_t>(mesh.faces()));
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge)
    maps[mesh.solid().neighbour(face, edge).face] = mesh.unfolded(face, edge);
  maps[static_cast<std::size_t>(face)] = glm::dmat4(1);
  std::vector<EditedSegment> near;
  for (const EditedSegment& segment : segments) {
    const auto& map = maps[static_cast<std::size_t>(segment.face)];
    if (!map) continue;
    near.push_back({face, glm::dvec2(*map * glm::dvec4(segment.a, 0, 1)),
                    glm::dvec2(*map * glm::dvec4(segment.b, 0, 1)), segment.word});
  }
  return near;
}

}  // namespace

glm::dvec2 snapped(const SolidMesh& mesh, std::span<const EditedSegment> segments, const FacePlace& pointer,
                   const SnapOptions& options) {
  if (options.free) return pointer.place;
  const std::vector<EditedSegment> near = segmentsNear(mesh, segments, pointer.face);
  Nearest end{pointer.place, options.reach};
  for (const glm::dvec2 corner : mesh.polygon()) end.offer(corner, corner);
  for (const EditedSegment& segment : near) {
    for (const glm::dvec2 place : {segment.a, segment.b}) {
      if (isOnFace(mesh, place)) end.offer(place, place);
    }
  }
  if (end.place) return *end.place;
  const glm::dvec2 grid = onGrid(pointer.place, options.grid);
  Nearest line{pointer.place, options.reach};
  for (const EditedSegment& segment : near) {
    const glm::dvec2 place = nearestOn(segment.a, segment.b, grid);
    if (isOnFace(mesh, place)) line.offer(place, nearestOn(segment.a, segment.b, pointer.place));
  }
  if (line.place) return *line.place;
  Nearest edge{pointer.place, options.reach};
  for (std::size_t i = 0; i < mesh.polygon().size(); ++i) {
    const glm::dvec2 from = mesh.polygon()[i];
    const glm::dvec2 to = mesh.polygon()[(i + 1) % mesh.polygon().size()];
    edge.offer(nearestOn(from, to, grid), nearestOn(from, to, pointer.place));
  }
  if (edge.place) return *edge.place;
  return isOnFace(mesh, grid) ? grid : pointer.place;
}

glm::dvec2 straightened(const SolidMesh& mesh, glm::dvec2 from, glm::dvec2 pointer, const SnapOptions& options) {
  std::vector<glm::dvec2> directions{{1, 0}, {0, 1}};
  for (const glm::dvec2 normal : mesh.edgeNormals()) directions.emplace_back(-normal.y, normal.x);
  const glm::dvec2 way = pointer - from;
  const glm::dvec2 best = *std::max_element(directions.begin(), directions.end(), [&](glm::dvec2 a, glm::dvec2 b) {
    return std::abs(glm::dot(a, way)) < std::abs(glm::dot(b, way)) - 1e-9;
  });
  const double length = glm::dot(best, way);
  const double whole = options.free ? length : std::round(length / options.grid) * options.grid;
  return from + best * whole;
}

}  // namespace platon
