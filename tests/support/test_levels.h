#pragma once

#include <string>

#include "server/match/level_rotation.h"

namespace platon {

/// A hexahedron with a floor under the start and the goal on the other side.
std::string farGoalText();
/// The same with the goal where players start, so that a round ends in its first tick with a player.
std::string nearGoalText();

LevelPointer levelOf(const std::string& text);

}  // namespace platon
