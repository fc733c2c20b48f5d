#include "levels/reach/reach_walls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shared/game/played_game.h"

namespace platon::reach_walls_test {
namespace {

// The posts at the corners are very short.
bool isPost(const ReachWall& wall) { return length(wall.line.b - wall.line.a) < 0.2; }

std::vector<ReachWall> wallsOf(const std::string& lines, const std::string& neighbour = "") {
  const auto level = cubeLevel("0 -200 200 0", {lines, neighbour});
  std::vector<ReachWall> walls = wallsNear(*level, UprightFaces(*level), 0);
  std::erase_if(walls, [](const ReachWall& wall) { return isPost(wall); });
  return walls;
}

TEST(ReachWallsTest, EveryElementIsWhatItIsToAPlayerWithThisUp) {
  using Kind = ReachWall::Kind;
  const std::vector<ReachWall> walls = wallsOf(
      "0 0 9 0\n0 20 9 20 hazard\n0 40 9 40 oneway\n0 60 9 60 door 3\n0 80 9 80 key 3\n0 100 9 100 plate 3\n"
      "0 120 9 120 up 2\n0 140 9 140 up 1");
  ASSERT_EQ(walls.size(), 7u) << "all but the one that does not block this up";
  const auto wallAt = [&](double y) {
    return *std::find_if(walls.begin(), walls.end(), [y](const ReachWall& wall) { return wall.line.a.y == y; });
  };
  EXPECT_EQ(wallAt(0).kind, Kind::kSolid);
  EXPECT_TRUE(wallAt(0).carries);
  EXPECT_EQ(wallAt(20).kind, Kind::kSolid);
  EXPECT_FALSE(wallAt(20).carries) << "nobody stands on a hazard";
  EXPECT_EQ(wallAt(40).kind, Kind::kOneway);
  EXPECT_EQ(wallAt(60).kind, Kind::kDoor);
  EXPECT_EQ(wallAt(60).doors, 8u);
  EXPECT_EQ(wallAt(80).kind, Kind::kTrigger);
  EXPECT_FALSE(wallAt(80).carries);
  EXPECT_EQ(wallAt(100).kind, Kind::kSolid);
  EXPECT_EQ(wallAt(120).kind, Kind::kSolid);
}

TEST(ReachWallsTest, SegmentsJustBehindAnEdgeBelongToTheFaceToo) {
  const std::vector<ReachWall> walls = wallsOf("0 0 9 0", "-230 5 -220 5\n0 0 9 0");
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_TRUE(walls[0].own);
  EXPECT_FALSE(walls[1].own);
  EXPECT_NEAR(walls[1].line.a.x, 250, 0.01) << "unfolded";
  EXPECT_NEAR(walls[1].line.a.y, 5, 0.01);
}

TEST(ReachWallsTest, EachCornerHasPostsOfItsFaceAndOfTheNeighbours) {
  const auto level = cubeLevel("0 -200 200 0", {});
  const std::vector<ReachWall> walls = wallsNear(*level, UprightFaces(*level), 0);
  for (const Vec corner : {Vec{-240, -240}, {240, -240}, {240, 240}, {-240, 240}}) {
    const auto at = [&](const ReachWall& wall) { return distance(corner, wall.line) < 0.1; };
    EXPECT_GE(std::count_if(walls.begin(), walls.end(), at), 6) << "a cut and a point, and those of two neighbours";
  }
  for (const ReachWall& wall : walls) EXPECT_TRUE(isPost(wall) && wall.kind == ReachWall::Kind::kSolid && wall.carries);
}

}  // namespace
}  // namespace platon::reach_walls_test
