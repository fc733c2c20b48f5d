#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "client/editor/edited_segment.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// The pieces of a segment that runs over edges, one for each face. `segment.a` lies on its face; `segment.b` in the
/// plane of that face, into which the others are unfolded along the segment. On an edge that is not reached exactly by
/// four decimals, both pieces run a little beyond it, so that both are cut there.
std::vector<EditedSegment> splitOverEdges(const SolidMesh& mesh, const EditedSegment& segment);

/// The same segment in the frame of the face on which `segment.a` lies when the faces are unfolded along the way from
/// the middle of `segment.face`. An `up` keeps pointing the same way.
EditedSegment onFaceOfFirstEnd(const SolidMesh& mesh, const EditedSegment& segment);

/// The plane of a face into which other faces are unfolded, in the order in which a pointer passes them.
class UnfoldedPlane {
 public:
  UnfoldedPlane(const SolidMesh& mesh, int face) : mesh_(&mesh), face_(face) {}

  /// Returns the place in the plane of the first face. A pointer that skips faces takes the way over the fewest edges.
  glm::dvec2 follow(const FacePlace& pointer);

 private:
  const SolidMesh* mesh_;
  int face_;
  glm::dmat4 toPlane_{1};  // from the frame of face_
};

}  // namespace platon
