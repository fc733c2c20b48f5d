#pragma once

#include <glm/vec2.hpp>

namespace platon {

/// How the player looks round the solid.
struct LookInput {
  bool held = false;        ///< the view turns; without it, it goes back
  glm::dvec2 direction{0};  ///< to the right and upwards, each -1 … 1
  glm::dvec2 turn{0};       ///< by which the view turns at once, while held: to the right and upwards, radians

  friend bool operator==(const LookInput&, const LookInput&) = default;
};

}  // namespace platon
