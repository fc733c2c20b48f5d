#include "tests/support/test_level.h"

#include <stdexcept>
#include <string>

namespace platon {

namespace {

std::shared_ptr<const Level> make(const std::string& start, const std::string& goal, const std::string& segment) {
  std::string text = "HEXAHEDRON\n" + start + "\n" + goal + "\n480\n";
  for (int face = 0; face < 6; ++face) {
    text += "%\n-240 -200 240 -200\n-200 200 200 200\n";
    if (face == 1) text += segment;
  }
  LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

}  // namespace

std::shared_ptr<const Level> flatLevel() { return make("0 -150 -150 0", "0 150 -180", ""); }

std::shared_ptr<const Level> cornerLevel() { return make("0 100 -150 0", "1 150 -180", "0 -200 0 -160\n"); }

std::shared_ptr<const Level> endlessLevel() { return make("0 -150 -150 0", "0 0 100", ""); }

}  // namespace platon
