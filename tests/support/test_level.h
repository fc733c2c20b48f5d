#pragma once

#include <memory>

#include "platon/game/level.h"

namespace platon {

/// A hexahedron with a floor on each face, which makes face 5 unreachable. The goal is on the floor to the right of the
/// start.
std::shared_ptr<const Level> flatLevel();

/// Like flatLevel, but the goal is on the next face to the right, behind a low segment.
std::shared_ptr<const Level> cornerLevel();

/// Like flatLevel, but the goal is unreachable.
std::shared_ptr<const Level> endlessLevel();

}  // namespace platon
