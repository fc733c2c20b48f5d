#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"
#include "client/scene/stage_model.h"
#include "levels/drawing/colour.h"

namespace platon {

/// A wall on a face: a strip with round ends, raised along the normal of the face. Level units in the frame of the
/// face.
struct Wall {
  static constexpr double kHeight = 12;  ///< of a segment

  glm::dvec2 a{0};
  glm::dvec2 b{0};
  double halfWidth = 2;
  double height = kHeight;
  Colour colour{1};
};

/// Where walls meet the edges of the faces from inside. Lengths in level units.
class EdgeMeetings {
 public:
  static constexpr double kStub = 4;  ///< a wall that goes no farther into a face only sticks out of the neighbour

  /// `solid` must outlive the object.
  EdgeMeetings(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces);

  /// Whether a wall that ends at `edge` of `face` goes on over it: a wall of the neighbour begins at the same place of
  /// the edge.
  bool goesOn(const Wall& wall, int face, int edge) const;

 private:
  using Interval = std::pair<double, double>;  // along the edge, counter-clockwise

  std::vector<Interval>& at(int face, int edge) { return meetings_[indexOf(face, edge)]; }
  std::size_t indexOf(int face, int edge) const;
  Interval meetingOf(const Wall& wall, int edge) const;
  void add(const Wall& wall, int face, int edge);

  const SolidMesh& solid_;
  std::vector<std::vector<Interval>> meetings_;  // by face and edge; sorted and disjoint
};

/// The walls of the segments without a word, by face.
std::vector<std::vector<Wall>> wallsOf(const StageModel& stage);

/// The walls of the elements, by face: thin low ledges for `oneway`, blocks for `up`, a zigzag for `hazard`, two rails
/// for `door`, a wall and a bar for `plate`. `up` and `door` are low while they are open, the bar while it is pressed.
/// `shares`: by Level::elements, how active each one looks, 0 … 1; the leaves of a door slide meanwhile.
std::vector<std::vector<Wall>> elementWallsOf(const StageModel& stage, std::span<const double> shares);

/// Where the walls of all segments that can block meet the edges. `stage` must outlive the result.
EdgeMeetings edgeMeetingsOf(const StageModel& stage);

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
