#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/pose.h"
#include "platon/game/solid.h"

namespace platon {

/// A Platonic solid in space: every face of its topology placed by unfolding from its neighbour about their common
/// edge. Level units; the solid's centre is the origin. In the frame of a face +z points out of the solid.
class SolidMesh {
 public:
  /// `faceSize` is the edge length in level units, more than 0.
  SolidMesh(SolidKind kind, double faceSize);

  const PlatonicSolid& solid() const { return *solid_; }
  int faces() const { return solid_->faces(); }
  double faceSize() const { return faceSize_; }

  /// Distances from the centre to every face and to every vertex.
  double inradius() const { return inradius_; }
  double circumradius() const { return circumradius_; }
  /// Distance from a face's centre to its edges.
  double apothem() const { return apothem_; }
  /// Angle between two neighbouring faces, inside, in radians.
  double dihedral() const { return dihedral_; }

  /// Corners of every face in its frame, counter-clockwise from vertex 0.
  const std::vector<glm::dvec2>& polygon() const { return polygon_; }
  /// Unit vectors out of every edge of a face, in its frame; edge 0 is the bottom.
  const std::vector<glm::dvec2>& edgeNormals() const { return edgeNormals_; }

  /// From a face's frame to space.
  const glm::dmat4& faceToWorld(int face) const { return faceToWorld_[static_cast<std::size_t>(face)]; }
  glm::dvec3 toWorld(int face, glm::dvec2 point) const;
  /// Unit, out of the solid.
  glm::dvec3 normal(int face) const { return glm::dvec3(faceToWorld(face)[2]); }

  /// The frame of the face behind `edge` in the frame of `face`, both laid flat.
  glm::dmat4 unfolded(int face, int edge) const;

  /// Something at `point` of a face whose up is the face's +y turned by `angle`, radians counter-clockwise.
  Pose pose(int face, glm::dvec2 point, double angle) const;
  /// The face that the ray from the centre through `point` leaves the solid by. `point` is not the centre.
  int faceTowards(glm::dvec3 point) const;
  /// `point` moved along its ray from the centre onto the surface. `point` is not the centre.
  glm::dvec3 onSurface(glm::dvec3 point) const;

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

}  // namespace platon
