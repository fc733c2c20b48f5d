#pragma once

#include <memory>

#include "platon/game/level.h"

namespace platon {

/// A hexahedron with a floor on each face, which shuts off face 5; the goal is to the right of the start.
std::shared_ptr<const Level> flatLevel();

/// The same, but the goal is on the next face to the right, behind a low wall.
std::shared_ptr<const Level> cornerLevel();

/// The same, but the goal is out of reach.
std::shared_ptr<const Level> endlessLevel();

}  // namespace platon
