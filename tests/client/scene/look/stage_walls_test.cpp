#include "client/scene/look/stage_walls.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "platon/game/game.h"

namespace platon::stage_walls_test {
namespace {

struct Walls {
  std::vector<Wall> active;
  std::vector<Wall> between;
  std::vector<Wall> open;
};

// The walls of one element on face 0, in both states.
Walls wallsOfElement(const std::string& word) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-120 0 120 0 " + word + "\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  const auto stage = makeStageModel(*result.level);
  const auto at = [&](double share) { return elementWallsOf(*stage, std::span(&share, 1))[0]; };
  return {at(1), at(0.5), at(0)};
}

double highest(const std::vector<Wall>& walls) {
  double height = 0;
  for (const Wall& wall : walls) height = std::max(height, wall.height);
  return height;
}

TEST(StageWalls, EverySegmentIsAWallOfTheHeight) {
  const LevelResult result = loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-100 20 100 -40\n%\n%\n%\n%\n%\n");
  ASSERT_TRUE(result.level);
  const auto walls = wallsOf(*makeStageModel(*result.level));
  ASSERT_EQ(walls.size(), 6U);
  ASSERT_EQ(walls[0].size(), 1U);
  EXPECT_EQ(walls[0][0].a, glm::dvec2(-100, 20));
  EXPECT_EQ(walls[0][0].b, glm::dvec2(100, -40));
  EXPECT_EQ(walls[0][0].height, Wall::kHeight);
  EXPECT_TRUE(walls[1].empty());
}

TEST(StageWalls, WhatDoesNotBlockIsLow) {
  for (const char* word : {"up 2", "door 5"}) {
    const Walls walls = wallsOfElement(word);
    EXPECT_EQ(highest(walls.active), Wall::kHeight) << word;
    EXPECT_LT(highest(walls.open), Wall::kHeight / 3) << word;
  }
  for (const char* word : {"checkpoint", "key 5"}) EXPECT_TRUE(wallsOfElement(word).active.empty()) << word;
}

TEST(StageWalls, AnUpThatLetsPassIsNoWall) { EXPECT_TRUE(wallsOfElement("up 2").open.empty()); }

TEST(StageWalls, WhatOpensIsBetweenItsStatesMeanwhile) {
  for (const char* word : {"up 2", "door 5", "plate 5"}) {
    const Walls walls = wallsOfElement(word);
    const auto heightOf = [](const std::vector<Wall>& all) { return all.empty() ? 0 : all.back().height; };
    EXPECT_NEAR(heightOf(walls.between), (heightOf(walls.active) + heightOf(walls.open)) / 2, 1e-9) << word;
  }
}

TEST(StageWalls, TheLeavesOfADoorMeetWhenItIsClosed) {
  const Walls walls = wallsOfElement("door 5");
  ASSERT_EQ(walls.active.size(), 2U) << "a rail on each side";
  ASSERT_EQ(walls.between.size(), 4U);
  EXPECT_GT(walls.between[0].b.x, walls.open[0].b.x);
  EXPECT_LT(walls.between[0].b.x, 0) << "a gap in the middle";
  EXPECT_EQ(walls.between[0].b.x, -walls.between[1].a.x);
  EXPECT_EQ(walls.active[0].a.x, -120);
  EXPECT_EQ(walls.active[0].b.x, 120);
}

TEST(StageWalls, WhatBlocksAlwaysDoesNotSink) {
  for (const char* word : {"hazard", "plate 5"}) {
    const Walls walls = wallsOfElement(word);
    EXPECT_GT(highest(walls.active), Wall::kHeight / 2) << word;
    EXPECT_GT(highest(walls.open), Wall::kHeight / 2) << word;
  }
}

TEST(StageWalls, AWallGoesOnOverAnEdgeWhereADoorBeginsButNotWhereACheckpointDoes) {
  const auto meets = [](const std::string& word) {
    const LevelResult result =
        loadLevel("HEXAHEDRON\n2 0 0 0\n2 60 80\n480\n%\n180 20 242 20\n%\n-242 20 -180 20" + word + "\n%\n%\n%\n%\n");
    if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
    const auto stage = makeStageModel(*result.level);
    for (int edge = 0; edge < 4; ++edge) {
      if (edgeMeetingsOf(*stage).goesOn({{180, 20}, {242, 20}}, 0, edge)) return true;
    }
    return false;
  };
  EXPECT_TRUE(meets(""));
  EXPECT_TRUE(meets(" door 1"));
  EXPECT_FALSE(meets(" checkpoint"));
}

TEST(StageWalls, WhatLetsPassFromOneSideIsAThinLedge) {
  for (const std::vector<Wall>& walls : {wallsOfElement("oneway").active, wallsOfElement("oneway").open}) {
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_LT(walls[0].height, Wall::kHeight / 2);
    EXPECT_LT(walls[0].halfWidth, StageModel::kRibbonWidth / 2);
    EXPECT_EQ(walls[0].a, glm::dvec2(-120, 0));
    EXPECT_EQ(walls[0].b, glm::dvec2(120, 0));
  }
}

TEST(StageWalls, WallsOfAnElementLieAlongItsSegment) {
  for (const char* word : {"up 2", "door 5", "hazard", "plate 5", "oneway"}) {
    for (const Wall& wall : wallsOfElement(word).active) {
      for (const glm::dvec2 end : {wall.a, wall.b}) {
        EXPECT_LE(std::abs(end.x), 120 + 1e-9) << word;
        EXPECT_LE(std::abs(end.y), 8) << word;
      }
    }
  }
}

}  // namespace
}  // namespace platon::stage_walls_test
