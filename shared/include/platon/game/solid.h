#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"

namespace platon {

enum class SolidKind : std::uint8_t { kTetrahedron, kHexahedron, kOctahedron, kDodecahedron, kIcosahedron };
inline constexpr int kSolidKinds = 5;

/// Name in level files: "TETRAHEDRON" …
std::string_view nameOf(SolidKind kind);

/// Topology of a Platonic solid. The frame of a face has its origin at the face's centre and +y up; the corners are
/// numbered counter-clockwise as seen from outside the solid. Edge i goes from corner i to corner i + 1, and edge 0 is
/// the bottom one.
///
/// Faces and vertices are numbered in rings from the bottom to the top, and within a ring counter-clockwise as seen
/// from above; docs/level_format.md draws the nets. Vertices, with the first number of each ring in parentheses:
///   tetrahedron   3 of the base (0), apex (3)
///   hexahedron    4 of the base (0), 4 of the top (4)
///   octahedron    4 of the middle (0), top (4), bottom (5)
///   dodecahedron  5 of the base (0), lower ring of 5 (5), upper ring of 5 (10), 5 of the top (15)
///   icosahedron   bottom (0), lower ring of 5 (1), upper ring of 5 (6), top (11)
class PlatonicSolid {
 public:
  /// The face on the other side of an edge.
  struct Neighbour {
    std::uint8_t face = 0;
    std::uint8_t edge = 0;  ///< the same edge as numbered in `face`; it runs the other way there
    Angle turn;             ///< added to an angle in this face's frame, gives the angle in the neighbour's frame
  };

  static const PlatonicSolid& of(SolidKind kind);

  SolidKind kind() const { return kind_; }
  int faces() const { return faces_; }
  int edgesPerFace() const { return edgesPerFace_; }
  /// 0 <= face < faces(), 0 <= edge < edgesPerFace().
  const Neighbour& neighbour(int face, int edge) const { return neighbours_[indexOf(face, edge)]; }
  /// Vertex of the solid at this corner of `face`.
  int vertex(int face, int corner) const { return vertices_[indexOf(face, corner)]; }

 private:
  // Corners of all faces of the dodecahedron, 12 * 5, and of the icosahedron, 20 * 3.
  static constexpr std::size_t kMaxCorners = 60;

  constexpr PlatonicSolid(SolidKind kind, int edgesPerFace, std::span<const std::uint8_t> vertices);
  constexpr Neighbour findNeighbour(int face, int edge) const;
  constexpr std::size_t indexOf(int face, int corner) const {
    return static_cast<std::size_t>(face * edgesPerFace_ + corner);
  }

  SolidKind kind_;
  int edgesPerFace_;
  int faces_;
  std::array<std::uint8_t, kMaxCorners> vertices_{};
  std::array<Neighbour, kMaxCorners> neighbours_{};
};

/// Smallest and largest edge length of a face in level units.
inline constexpr std::int32_t kMinFaceSize = 200;
inline constexpr std::int32_t kMaxFaceSize = 65536;

/// Midpoint of an edge in the frame of its face, with an error of at most 2^-28 of the edge length. `faceSize` is the
/// edge length in level units, kMinFaceSize … kMaxFaceSize.
PrecisePoint edgeMiddle(SolidKind kind, std::int32_t faceSize, int edge);

/// Corners of a face in its frame, in subunits. Each coordinate is the integer nearest to the exact one, and below
/// 2^26.
std::vector<Point> facePolygon(SolidKind kind, std::int32_t faceSize);

}  // namespace platon
