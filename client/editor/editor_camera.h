#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include "client/scene/camera.h"
#include "client/scene/solid_mesh.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"

namespace platon {

/// A camera that turns round a solid and looks at its centre. The pointer, the wheel and the arrow keys turn it.
class EditorCamera {
 public:
  /// The pictures have w × h pixels.
  void resize(std::uint32_t w, std::uint32_t h);
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

  /// Follows the pointer. While a button other than the left one is held and `turns`, the solid turns with it; the
  /// wheel moves nearer.
  void handle(const PointerEvent& event, const SolidMesh& mesh, bool turns);
  /// Follows the pointer while it is used for something else.
  void look(const PointerEvent& event);
  /// Returns whether the key turns or moves the camera.
  bool handle(const KeyEvent& event, const SolidMesh& mesh);

  Camera camera(const SolidMesh& mesh) const;

 private:
  std::uint32_t width_ = 1280;
  std::uint32_t height_ = 720;
  glm::dquat orientation_{1, 0, 0, 0};
  double distance_ = 1000;  // from the centre of the solid
  glm::dvec2 pointer_{0};   // on the virtual screen
  bool turning_ = false;    // a button that turns the solid is held
};

}  // namespace platon
