#pragma once

#include <glm/vec2.hpp>

#include "client/scene/look_input.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// Turns a view round the solid while the player asks for it, and back afterwards.
class LookRound {
 public:
  static constexpr double kSpeed = 2;      ///< radians a second
  static constexpr double kReturn = 7;     ///< rate of the way back, per second
  static constexpr double kMaxReturn = 5;  ///< radians a second
  static constexpr double kMaxUp = 1.5;    ///< largest angle upwards and downwards, radians

  /// Turns for `seconds` ≥ 0, and by LookInput::turn.
  void update(const LookInput& input, double seconds);
  void reset() { angles_ = glm::dvec2(0); }

  /// To the right and upwards, radians.
  glm::dvec2 angles() const { return angles_; }
  /// The turned view: the same without angles, and with larger ones of the whole solid.
  ViewPoint turned(const ViewPoint& view, const SolidMesh& mesh) const;

 private:
  glm::dvec2 angles_{0};
};

}  // namespace platon
