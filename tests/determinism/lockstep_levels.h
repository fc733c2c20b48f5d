#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/level.h"
#include "tests/sim/files.h"

namespace platon::sim {

/// The files with this ending in a folder and its subfolders, by name. Throws std::runtime_error when there is none,
/// since tests of each would then pass.
inline std::vector<std::string> filesIn(const std::string& folder, const std::string& ending) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ending) found.push_back(entry.path().string());
  }
  if (found.empty()) throw std::runtime_error("no file " + folder + "/*" + ending);
  std::sort(found.begin(), found.end(), [](const std::filesystem::path& a, const std::filesystem::path& b) {
    return std::pair(a.filename(), a) < std::pair(b.filename(), b);
  });
  return found;
}

inline std::vector<std::string> shippedLevels() { return filesIn("levels", ".level"); }

/// Every level that is shipped, and the hard ones beside the golden recordings.
inline std::vector<std::string> lockstepLevels() {
  std::vector<std::string> all = shippedLevels();
  for (std::string& hard : filesIn("tests/determinism/golden/levels", ".level")) all.push_back(std::move(hard));
  return all;
}

/// Throws std::invalid_argument with the first error.
inline std::shared_ptr<const Level> levelFrom(const std::string& path) {
  const auto bytes = readBytes(path, kMaxLevelBytes + 1);
  LevelResult result = loadLevel({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!result.level) throw std::invalid_argument(format(path, result.diagnostics.at(0)));
  return result.level;
}

/// For the name of a test: the file's, without folder and ending.
inline std::string testName(const std::string& path) { return "level_" + std::filesystem::path(path).stem().string(); }

}  // namespace platon::sim
