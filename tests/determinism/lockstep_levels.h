#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/level.h"
#include "tests/support/files.h"

namespace platon::sim {

/// Every level that is shipped, and the hard ones beside the golden recordings.
inline std::vector<std::string> lockstepLevels() {
  std::vector<std::string> all = shippedLevels();
  for (std::string& hard : filesIn("tests/determinism/golden/levels", ".level")) all.push_back(std::move(hard));
  return all;
}

/// Throws std::invalid_argument with the first error.
inline std::shared_ptr<const Level> levelFrom(const std::string& path) {
  LevelResult result = loadLevel(readText(path));
  if (!result.level) throw std::invalid_argument(format(path, result.diagnostics.at(0)));
  return result.level;
}

/// For the name of a test: the file's, without folder and ending.
inline std::string testName(const std::string& path) { return "level_" + std::filesystem::path(path).stem().string(); }

}  // namespace platon::sim
