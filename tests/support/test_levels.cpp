#include "tests/support/test_levels.h"

#include <stdexcept>

#include "platon/game/level.h"

namespace platon {
namespace {

std::string withGoal(const std::string& goal) {
  return "HEXAHEDRON\n0 -100 -150 0\n" + goal + "\n480\n%\n-240 -200 100 -200\n%\n%\n%\n%\n%\n";
}

}  // namespace

std::string farGoalText() { return withGoal("3 120 80"); }

std::string nearGoalText() { return withGoal("0 -100 -150"); }

LevelPointer levelOf(const std::string& text) {
  LevelResult result = loadLevel(text);
  if (!result.level) throw std::runtime_error("the level of the test is invalid");
  return result.level;
}

}  // namespace platon
