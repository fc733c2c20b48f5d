#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// The view of a camera that stands still. It shows the whole face of the player; of a large face it shows a part, and
/// another one when the player comes near the border of the picture.
class FaceHold {
 public:
  /// The view of the player, which is the last one as long as the face, the player's up and the zoom stay the same and
  /// the player stays away from the border of the picture. `zoom` is a magnification, more than 0.
  ViewPoint view(const Pose& player, const SolidMesh& mesh, double zoom);
  /// The next view does not depend on the last one.
  void reset() { view_.reset(); }

 private:
  bool holds(const Pose& player, double zoom) const;

  std::optional<ViewPoint> view_;
  glm::dvec3 centre_{0};  // of the picture, on the face
  glm::dvec3 normal_{0};
  double distance_ = 0;  // of the eye from the face
  double zoom_ = 1;
  bool whole_ = false;  // the view shows the whole face
};

}  // namespace platon
