#include "tests/levels/shipped_level.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "tests/support/files.h"

namespace platon {

std::string shippedName(const std::string& file) { return std::filesystem::path(file).stem().string(); }

ShippedLevel::ShippedLevel(const std::string& file) : name_(shippedName(file)) {
  level_ = loadLevel(readText(file)).level;
  if (!level_) throw std::runtime_error(file + " is invalid; see platon-level check");
  recording_ = readBytes("levels/data/ways/" + name_ + ".recording");
  way_ = readRecordedWay(recording_);
}

std::shared_ptr<const Level> changed(const Level& level,
                                     const std::function<std::string(int, const std::string&)>& change) {
  std::istringstream text(level.text);
  std::string result;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) result += change(number, line) + "\n";
  return loadLevel(result).level;
}

}  // namespace platon
