#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "platon/game/level.h"

namespace platon {

/// Loads a level text. Throws std::invalid_argument with its first error.
inline std::shared_ptr<const Level> levelOf(const std::string& text) {
  LevelResult result = loadLevel(text);
  if (!result.level) throw std::invalid_argument(format("level", result.diagnostics.at(0)));
  return result.level;
}

/// A hexahedron with a floor on each face, which makes face 5 unreachable. The goal is on the floor to the right of the
/// start.
std::shared_ptr<const Level> flatLevel();
/// Like flatLevel, but the goal is on the next face to the right, behind a low segment.
std::shared_ptr<const Level> cornerLevel();
/// Like flatLevel, but the goal is unreachable.
std::shared_ptr<const Level> endlessLevel();

/// Text of a level: a hexahedron with a floor under the start and the goal on the opposite face.
std::string farGoalText();
/// The same with the goal at the start, so that a round ends in its first tick with a player.
std::string nearGoalText();

}  // namespace platon
