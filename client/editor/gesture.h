#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "client/editor/edited_segment.h"
#include "client/editor/over_edges.h"
#include "client/editor/picking.h"
#include "client/editor/snapping.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// A segment that follows the pointer while the button is held: one that is drawn, or one that is moved by an end or as
/// a whole. `mesh` must outlive it.
class Gesture {
 public:
  /// Draws a segment from `from`.
  Gesture(const SolidMesh& mesh, const FacePlace& from, const SegmentWord& word);
  /// Moves a segment that was grabbed at a place of its face.
  Gesture(const SolidMesh& mesh, const EditedSegment& segment, const PickedSegment& picked, glm::dvec2 grabbed);

  /// Follows the pointer. `straight`: only horizontal, vertical and parallel to an edge. `segments` are those that
  /// attract the pointer.
  void follow(const FacePlace& pointer, std::span<const EditedSegment> segments, const SnapOptions& options,
              bool straight);

  /// The segment as it is now, in a piece for each face over which it runs. Empty while it has no length.
  std::vector<EditedSegment> pieces() const;
  /// The segment that is moved; nothing while one is drawn.
  std::optional<std::size_t> moved() const { return moved_; }

 private:
  bool isOnFace(glm::dvec2 place) const;

  const SolidMesh* mesh_;
  EditedSegment first_;  // as it was at the beginning
  EditedSegment now_;    // in the plane of its face
  PickedSegment::Part part_ = PickedSegment::Part::kSecondEnd;
  std::optional<std::size_t> moved_;
  glm::dvec2 grabbed_{0};
  bool moves_ = false;  // the pointer has left the place where it grabbed the segment
  UnfoldedPlane plane_;
};

}  // namespace platon
