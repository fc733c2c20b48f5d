#pragma once

#include <glm/vec3.hpp>

#include "client/scene/solid_mesh.h"

namespace platon {

/// How a sound from a place is heard.
struct Heard {
  double gain = 1;  ///< 0 … 1
  double pan = 0;   ///< −1 left … 1 right
};

/// Distance at which a sound has half its gain, level units.
inline constexpr double kHalfGainDistance = 260;
/// Distance to the side from which on a sound comes from that side alone, level units.
inline constexpr double kFullPanDistance = 700;

/// How a player at `listener` hears a sound from `place`: by the distance through the solid, with the player's right on
/// the right. The gain is 1 at the distance 0, and falls with the square of the distance.
Heard hear(const Pose& listener, glm::dvec3 place);

}  // namespace platon
