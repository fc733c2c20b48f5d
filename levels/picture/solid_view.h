#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "levels/drawing/solid_frame.h"
#include "levels/picture/canvas.h"
#include "platon/exact/angle.h"

namespace platon {

/// A solid as seen from far away, in a parallel projection. The directions are unit vectors in space, at right angles
/// to each other.
struct SolidView {
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 towards{0, 0, 1};  ///< from the solid to the viewer

  /// Where a face lies in a picture with a pixel per level unit. The solid's centre is at its origin.
  PlaneMap faceMap(const SolidFrame& solid, int face) const;
  /// True when the outer side of the face is seen.
  bool shows(const SolidFrame& solid, int face) const;
  /// How much light falls on a face, 0 … 1. The light comes from above, on the viewer's left.
  double brightness(const SolidFrame& solid, int face) const;
};

/// The view of a standing solid, obliquely from above, with `face` in front. At the bottom of the face is the edge that
/// is nearest to down, for an up of `angle`. A solid has the same outline for all faces and angles.
SolidView frontView(const SolidFrame& solid, int face, Angle angle);

/// The view from the opposite side. It shows exactly the faces that `view` does not show.
SolidView oppositeOf(const SolidView& view);

}  // namespace platon
