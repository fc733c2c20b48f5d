#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"

namespace platon::properties {

/// A rotation of a solid onto itself.
struct SolidSymmetry {
  struct Image {
    std::uint32_t face = 0;
    int edge = 0;  ///< image of edge 0
  };
  std::vector<Image> images;  ///< by face
  int edgesPerFace = 0;

  /// Rotation from the frame of a face to the frame of its image.
  Angle turn(std::uint32_t face) const { return Angle(images[face].edge * (Angle::kTurn / edgesPerFace)); }
  /// True if it maps lattice points to lattice points: every frame rotates by quarter turns.
  bool isExact() const {
    for (std::uint32_t face = 0; face < images.size(); ++face) {
      if (turn(face).centidegrees() % (Angle::kTurn / 4) != 0) return false;
    }
    return true;
  }
  /// True if it only changes the numbers of faces: no frame rotates.
  bool onlyRenumbers() const {
    for (const Image& image : images) {
      if (image.edge != 0) return false;
    }
    return true;
  }
};

/// The rotation that maps edge 0 of face 0 to this edge.
inline SolidSymmetry symmetryOf(const PlatonicSolid& solid, SolidSymmetry::Image firstImage) {
  const int edges = solid.edgesPerFace();
  SolidSymmetry symmetry{std::vector<SolidSymmetry::Image>(static_cast<std::size_t>(solid.faces())), edges};
  std::vector<bool> known(symmetry.images.size());
  std::vector<std::uint32_t> found{0};
  symmetry.images[0] = firstImage;
  known[0] = true;
  for (std::size_t next = 0; next < found.size(); ++next) {
    const std::uint32_t face = found[next];
    const SolidSymmetry::Image image = symmetry.images[face];
    for (int edge = 0; edge < edges; ++edge) {
      const PlatonicSolid::Neighbour& behind = solid.neighbour(static_cast<int>(face), edge);
      if (known[behind.face]) continue;
      const PlatonicSolid::Neighbour& there =
          solid.neighbour(static_cast<int>(image.face), (edge + image.edge) % edges);
      symmetry.images[behind.face] = {there.face, (there.edge - behind.edge + edges) % edges};
      known[behind.face] = true;
      found.push_back(behind.face);
    }
  }
  return symmetry;
}

/// All rotations of the solid, including the identity: one for each edge of each face.
inline std::vector<SolidSymmetry> symmetriesOf(const PlatonicSolid& solid) {
  std::vector<SolidSymmetry> all;
  for (std::uint32_t face = 0; face < static_cast<std::uint32_t>(solid.faces()); ++face) {
    for (int edge = 0; edge < solid.edgesPerFace(); ++edge) all.push_back(symmetryOf(solid, {face, edge}));
  }
  return all;
}

}  // namespace platon::properties
