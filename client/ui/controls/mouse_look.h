#pragma once

#include <glm/vec2.hpp>

#include "client/scene/camera_controls.h"
#include "client/ui/pointer_event.h"

namespace platon {

/// Looks round the solid while the right button of the mouse is held: the solid follows the pointer.
class MouseLook {
 public:
  static constexpr double kTurn = 0.006;  ///< radians a unit of the virtual screen, which is 720 high

  void handle(const PointerEvent& event);
  /// The button counts as released until it is pressed again.
  void release();

  /// How the player looks round since the last call, with what keys and gamepad do.
  LookInput take(LookInput others);

 private:
  bool held_ = false;
  glm::dvec2 place_{0};  // of the pointer
  glm::dvec2 turn_{0};   // since the last `take`
};

}  // namespace platon
