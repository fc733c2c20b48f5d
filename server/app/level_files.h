#pragma once

#include <string>
#include <vector>

#include "server/match/level_rotation.h"

namespace platon {

/// Levels from files, and what is odd but no error in them, a line each.
struct LoadedLevels {
  std::vector<LevelPointer> levels;
  std::vector<std::string> warnings;
};

/// Reads the levels in this order. Throws ProgramError: kUsage when a file cannot be read, kLevel with everything found
/// in all of them when any is invalid.
LoadedLevels loadLevelFiles(const std::vector<std::string>& paths);

/// The levels that come with the game, in the order in which they are played: beside the installed program, or in the
/// source tree that it was built from. Throws ProgramError when they are not there.
std::vector<std::string> shippedLevelFiles();

}  // namespace platon
