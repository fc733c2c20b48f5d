#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/level.h"
#include "tests/support/files.h"

namespace platon::sim {

/// The levels of the golden recordings: one of each solid, and hard ones.
inline std::vector<std::string> lockstepLevels() { return filesIn("tests/determinism/golden/levels", ".level"); }

/// Loads a level file. Throws std::invalid_argument with its first error.
inline std::shared_ptr<const Level> levelFrom(const std::string& path) {
  LevelResult result = loadLevel(readText(path));
  if (!result.level) throw std::invalid_argument(format(path, result.diagnostics.at(0)));
  return result.level;
}

/// Name of the test of a file: `level_` and the file name without extension.
inline std::string testName(const std::string& path) { return "level_" + std::filesystem::path(path).stem().string(); }

}  // namespace platon::sim
