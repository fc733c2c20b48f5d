#pragma once

#include <string>
#include <vector>

#include "server/match/level_rotation.h"

namespace platon {

/// Levels read from files, and the warnings about them, a line each.
struct LoadedLevels {
  std::vector<LevelPointer> levels;
  std::vector<std::string> warnings;
};

/// Reads levels, in order. Throws ProgramError: kUsage when a file cannot be read, kLevel with the errors and warnings
/// of all files when a level is invalid. Of each file at most 100 errors and warnings are reported, and how many more
/// there are.
LoadedLevels loadLevelFiles(const std::vector<std::string>& paths);

/// Files of the levels that come with the game, in order. They lie beside the installed program or in the source tree
/// from which it was built. Throws ProgramError if they are in neither place; its text ends with `otherwise`, which
/// says what the user can do.
std::vector<std::string> shippedLevelFiles(
    const std::string& otherwise = "name level files, as in 'platon-server my.level'");

}  // namespace platon
