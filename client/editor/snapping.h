#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "client/editor/edited_segment.h"
#include "client/scene/solid_mesh.h"

namespace platon {

struct SnapOptions {
  double grid = 10;   ///< level units
  double reach = 8;   ///< level units within which ends, corners, segments and edges attract
  bool free = false;  ///< no snapping
};

/// Snaps a place on a face: to ends of segments and corners of the face, else to segments, else to edges, else to the
/// grid. Segments of neighbouring faces count where they lie when the faces are unfolded, so that a segment can be
/// continued over an edge. The result is on the face.
glm::dvec2 snapped(const SolidMesh& mesh, std::span<const EditedSegment> segments, const FacePlace& pointer,
                   const SnapOptions& options);

/// The place nearest to `pointer` on a straight way from `from`: horizontal, vertical or parallel to an edge of the
/// face, in whole steps of the grid unless options.free. Both are in the plane of a face.
glm::dvec2 straightened(const SolidMesh& mesh, glm::dvec2 from, glm::dvec2 pointer, const SnapOptions& options);

}  // namespace platon
