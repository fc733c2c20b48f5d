#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/scene/pose.h"
#include "platon/game/solid.h"

namespace platon {

/// Geometry of a Platonic solid in space. Each face is placed by folding it about the edge it shares with a placed
/// neighbour. Level units; the origin is the solid's centre. In the frame of a face, +z points out of the solid.
class SolidMesh {
 public:
  /// `faceSize` is the edge length in level units, more than 0.
  SolidMesh(SolidKind kind, double faceSize);

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

  /// The pose at `point` of a face whose up is the face's +y rotated by `angle`, radians counter-clockwise.
  Pose pose(int face, glm::dvec2 point, double angle) const;
  /// The face that the ray from the centre through `point` intersects. `point` is not the centre.
  int faceTowards(glm::dvec3 point) const;
  /// Projects `point` from the centre onto the surface. `point` is not the centre.
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
