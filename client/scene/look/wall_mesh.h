#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/scene/look/edge_meetings.h"
#include "client/scene/look/wall.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// A corner of the surface of a wall, in the frame of its face: z is the height above the face.
struct WallVertex {
  glm::vec3 place{0};
  std::array<std::int8_t, 4> normal{};   ///< outward, × 127; the last one is 0
  std::array<std::uint8_t, 4> colour{};  ///< sRGB × 255; the last one is 255
  /// Of a corner of a top: how far it is from the axis of the wall, in the plane of the face: level units ×
  /// kAsideScale. A painter widens a top that is seen almost from the side, so that it does not break into dashes. 0
  /// for sides.
  std::array<std::int8_t, 2> aside{};
  std::array<std::int8_t, 2> unused{};  ///< keeps vertices aligned

  static constexpr double kAsideScale = 127 / 8.0;
};

/// The surface of walls as flat triangles, counter-clockwise from outside. The undersides, which lie on the faces, are
/// left out.
struct WallMesh {
  struct Part {
    std::size_t first = 0;  ///< index into `triangles`
    std::size_t count = 0;  ///< of indices
  };

  std::vector<WallVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< three indices each
  std::vector<Part> faces;               ///< by face
};

/// The most triangles of a mesh of many walls; few walls have rounder ends.
inline constexpr std::size_t kMaxTrianglesPerWall = 12;

/// The walls of each face, cut at its edges. Where a wall goes on over an edge, it leans along the plane that bisects
/// the two faces: its top is lifted by height · (n1 + n2) / (1 + n1 · n2) there. So walls on two faces that meet at an
/// edge have no gap between them. A wall that does not go on ends upright at the edge, and does not overhang it.
WallMesh makeWallMesh(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces,
                      const EdgeMeetings& meetings);

/// The same where these are all walls.
WallMesh makeWallMesh(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces);

}  // namespace platon
