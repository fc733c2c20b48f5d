#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"

namespace platon {

/// Subunits to level units. Exact: every coordinate of the simulation is a double.
inline glm::dvec2 toUnits(Point point) {
  return {double{1} * point.x / kSubunitsPerUnit, double{1} * point.y / kSubunitsPerUnit};
}

/// Angle in radians, counter-clockwise, in [0, 2π).
inline double toRadians(Angle angle) { return angle.centidegrees() * (6.283185307179586 / Angle::kTurn); }

/// Geometry of a Platonic solid in space. Each face is placed by folding it about the edge it shares with a placed
/// neighbour. Level units; the origin is the solid's centre. In the frame of a face, +z points out of the solid.
class SolidFrame {
 public:
  /// `faceSize` is the edge length in level units, more than 0.
  SolidFrame(SolidKind kind, double faceSize);

  const PlatonicSolid& solid() const { return *solid_; }
  int faces() const { return solid_->faces(); }
  double faceSize() const { return faceSize_; }

  /// Distances from the solid's centre to its faces and to its vertices.
  double inradius() const { return inradius_; }
  double circumradius() const { return circumradius_; }
  /// Distance from a face's centre to its edges.
  double apothem() const { return apothem_; }
  /// Interior angle between neighbouring faces, radians.
  double dihedral() const { return dihedral_; }

  /// Corners of a face in its frame, counter-clockwise from vertex 0. All faces are alike.
  const std::vector<glm::dvec2>& polygon() const { return polygon_; }
  /// Outward unit normals of the edges of a face, in its frame; edge 0 is the bottom.
  const std::vector<glm::dvec2>& edgeNormals() const { return edgeNormals_; }

  /// Transforms from a face's frame to space.
  const glm::dmat4& faceToWorld(int face) const { return faceToWorld_[static_cast<std::size_t>(face)]; }
  glm::dvec3 toWorld(int face, glm::dvec2 point) const;
  /// Outward unit normal of a face.
  glm::dvec3 normal(int face) const { return glm::dvec3(faceToWorld(face)[2]); }

  /// Transforms from the frame of the face behind `edge` to that of `face`, with both faces unfolded into a plane.
  glm::dmat4 unfolded(int face, int edge) const;

 private:
  void placeFaces();

  const PlatonicSolid* solid_;
  double faceSize_;
  double apothem_;
  double dihedral_;
  double inradius_;
  double circumradius_;
  std::vector<glm::dvec2> polygon_;
  std::vector<glm::dvec2> edgeNormals_;
  std::vector<glm::dmat4> faceToWorld_;
};

/// A solid unfolded into a plane: each face but one hangs on an edge that it shares with another. No two faces overlap.
/// Level units, +y up.
class Unfolding {
 public:
  /// An edge of the solid at which its two faces are joined in the unfolding.
  struct Hinge {
    int face = 0;
    int edge = 0;
  };

  explicit Unfolding(const SolidFrame& solid);

  /// The joined edges, each seen from the face that was placed first. One less than there are faces.
  const std::vector<Hinge>& hinges() const { return hinges_; }
  /// Transforms from the frame of a face to the plane.
  const glm::dmat4& faceToPlane(int face) const { return faceToPlane_[static_cast<std::size_t>(face)]; }

 private:
  std::vector<Hinge> hinges_;
  std::vector<glm::dmat4> faceToPlane_;
};

}  // namespace platon
