#pragma once

#include <string>

#include "server/match/level_rotation.h"

namespace platon {

/// Text of a level: a hexahedron with a floor under the start and the goal on the opposite face.
std::string farGoalText();
/// The same with the goal at the start, so that a round ends in its first tick with a player.
std::string nearGoalText();

/// Throws std::runtime_error if the level is invalid.
LevelPointer levelOf(const std::string& text);

}  // namespace platon
