#include "client/scene/look/edge_way.h"

#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon::edge_way_test {
namespace {

// Whether the way from the middle of face 0 upwards, and the one to the side, is free past a segment above the middle.
struct Ways {
  bool up = false;
  bool aside = false;
};

Ways waysPast(const std::string& word, bool active) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-50 40 50 40 " + word + "\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  const auto stage = makeStageModel(*result.level);
  ElementStates states = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
  states.active.assign(states.active.size(), active ? 1 : 0);
  return {wayIsFree(*stage, states, 0, {0, 0}, {0, 240}), wayIsFree(*stage, states, 0, {0, 0}, {240, 0})};
}

TEST(EdgeWay, ASegmentBlocksOnlyTheWayThatItCrosses) {
  const Ways ways = waysPast("", true);
  EXPECT_FALSE(ways.up);
  EXPECT_TRUE(ways.aside);
}

TEST(EdgeWay, DoorsAndUpsBlockUntilTheyAreOpen) {
  for (const char* word : {"door 5", "up 2"}) {
    EXPECT_FALSE(waysPast(word, true).up) << word;
    EXPECT_TRUE(waysPast(word, false).up) << word;
  }
}

TEST(EdgeWay, OtherElementsBlockAsTheyDoInTheGame) {
  EXPECT_FALSE(waysPast("plate 5", false).up);
  for (const char* word : {"hazard", "checkpoint", "key 5", "oneway"}) EXPECT_TRUE(waysPast(word, true).up) << word;
}

}  // namespace
}  // namespace platon::edge_way_test
