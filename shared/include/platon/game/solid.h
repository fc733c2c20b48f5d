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

/// "TETRAHEDRON" …
std::string_view nameOf(SolidKind kind);

/// The topology of a Platonic solid. Face frame: origin at the face's centre, +y up, edge 0 at the bottom from vertex 0
/// to vertex 1, counter-clockwise as seen from outside the solid. Edge i goes from corner i to corner i + 1.
///
/// Faces and vertices are numbered in rings from below upwards, within a ring in the sense in which a walker outside
/// goes to the right; docs/level_format.md draws the nets. Vertices, with the number of each ring's first:
///   tetrahedron   3 round the base (0), apex (3)
///   hexahedron    4 round the base (0), 4 above them (4)
///   octahedron    4 round the middle (0), top (4), bottom (5)
///   dodecahedron  5 round the base (0), 5 above them (5), 5 between and above these (10), 5 above those (15)
///   icosahedron   bottom (0), lower ring (1), upper ring, each between two of the lower (6), top (11)
class PlatonicSolid {
 public:
  /// What lies behind an edge: edge `edge` of face `face`, reversed.
  struct Neighbour {
    std::uint8_t face = 0;
    std::uint8_t edge = 0;
    Angle turn;  ///< what is added to an angle in this face's frame to get it in the neighbour's
  };

  static const PlatonicSolid& of(SolidKind kind);

  SolidKind kind() const { return kind_; }
  int faces() const { return faces_; }
  int edgesPerFace() const { return edgesPerFace_; }
  /// 0 <= face < faces(), 0 <= edge < edgesPerFace().
  const Neighbour& neighbour(int face, int edge) const { return neighbours_[slot(face, edge)]; }
  /// Index of the solid's vertex at corner `corner` of `face`, the same for all faces that meet there.
  int vertex(int face, int corner) const { return corners_[slot(face, corner)]; }

 private:
  /// Dodecahedron and icosahedron have the most: 12 * 5 = 20 * 3.
  static constexpr std::size_t kMaxCorners = 60;

  constexpr PlatonicSolid(SolidKind kind, int edgesPerFace, std::span<const std::uint8_t> corners);
  constexpr Neighbour find(int face, int edge) const;
  constexpr std::size_t slot(int face, int corner) const {
    return static_cast<std::size_t>(face * edgesPerFace_ + corner);
  }

  SolidKind kind_;
  int edgesPerFace_;
  int faces_;
  std::array<std::uint8_t, kMaxCorners> corners_{};
  std::array<Neighbour, kMaxCorners> neighbours_{};
};

/// Smallest and largest edge length of a face, level units.
inline constexpr std::int32_t kMinFaceSize = 200;
inline constexpr std::int32_t kMaxFaceSize = 65536;

/// The middle of an edge of every face, within 2^-28 of the edge length.
PrecisePoint edgeMiddle(SolidKind kind, std::int32_t faceSize, int edge);

/// The corners of every face with the given edge length in level units (kMinFaceSize … kMaxFaceSize), in subunits,
/// each coordinate the integer nearest to the true one. All are below 2^26.
std::vector<Point> facePolygon(SolidKind kind, std::int32_t faceSize);

}  // namespace platon
