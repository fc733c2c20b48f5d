#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>

#include "levels/drawing/solid_frame.h"

namespace platon {

/// A solid unfolded into a plane: each face but one hangs on an edge that it shares with another. No two faces overlap.
/// Level units, +y up.
class Net {
 public:
  /// An edge of the solid at which its two faces are joined in the net.
  struct Hinge {
    int face = 0;
    int edge = 0;
  };

  explicit Net(const SolidFrame& solid);

  /// The joined edges, each seen from the face that was placed first. One less than there are faces.
  const std::vector<Hinge>& hinges() const { return hinges_; }
  /// Transforms from the frame of a face to the plane.
  const glm::dmat4& faceToPlane(int face) const { return faceToPlane_[static_cast<std::size_t>(face)]; }

 private:
  std::vector<Hinge> hinges_;
  std::vector<glm::dmat4> faceToPlane_;
};

}  // namespace platon
