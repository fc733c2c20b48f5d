#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include "client/scene/camera.h"
#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// A camera that turns round a solid and looks at its centre.
class EditorCamera {
 public:
  /// Looks at the face of the pose, a little from the side, with its up at the top, from where the whole solid is seen.
  void showAll(const SolidMesh& mesh, const Pose& pose);
  /// Looks at the middle of the face of the pose, with its up at the top, at the same distance.
  void centre(const Pose& pose);
  /// Turns the solid so that its surface follows a pointer that moves by `way` on the virtual screen.
  void drag(const SolidMesh& mesh, glm::dvec2 way);
  /// Turns the solid by these angles to the right and upwards, radians.
  void turn(double right, double up);
  /// Moves nearer by this many notches of the wheel, or away if negative.
  void zoom(const SolidMesh& mesh, double notches);

  /// The camera for pictures of w × h pixels.
  Camera camera(const SolidMesh& mesh, std::uint32_t w, std::uint32_t h) const;

 private:
  glm::dquat orientation_{1, 0, 0, 0};
  double distance_ = 1000;  // from the centre of the solid
};

}  // namespace platon
