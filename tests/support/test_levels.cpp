#include "tests/support/test_levels.h"

namespace platon {

namespace {

std::shared_ptr<const Level> withFloors(const std::string& start, const std::string& goal, const std::string& segment) {
  std::string text = "HEXAHEDRON\n" + start + "\n" + goal + "\n480\n";
  for (int face = 0; face < 6; ++face) {
    text += "%\n-240 -200 240 -200\n-200 200 200 200\n";
    if (face == 1) text += segment;
  }
  return levelOf(text);
}

std::string withGoal(const std::string& goal) {
  return "HEXAHEDRON\n0 -100 -150 0\n" + goal + "\n480\n%\n-240 -200 100 -200\n%\n%\n%\n%\n%\n";
}

}  // namespace

std::shared_ptr<const Level> flatLevel() { return withFloors("0 -150 -150 0", "0 150 -180", ""); }

std::shared_ptr<const Level> cornerLevel() { return withFloors("0 100 -150 0", "1 150 -180", "0 -200 0 -160\n"); }

std::shared_ptr<const Level> endlessLevel() { return withFloors("0 -150 -150 0", "0 0 100", ""); }

std::string farGoalText() { return withGoal("3 120 80"); }

std::string nearGoalText() { return withGoal("0 -100 -150"); }

}  // namespace platon
