#include "levels/reach/reach.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon::reach_test {
namespace {

const std::string kFlat = "-240 -200 240 -200\n";
// On the right of the floor, behind a door.
const std::string kRoom = "60 -200 60 -20 door 1\n60 -20 240 -20\n";

std::optional<int> crossingsToGoal(const std::string& lines, const std::string& goal, int most = 2) {
  return Reach(*cubeLevel("0 0 -180 0", {kFlat + lines}, goal), most).crossingsToGoal();
}

TEST(ReachTest, AGoalOnTheFloorNeedsNoCrossing) { EXPECT_EQ(crossingsToGoal("", "0 100 -184"), 0); }

TEST(ReachTest, AGoalOutOfReachOfAJumpNeedsMore) {
  const std::string shelf = "80 -100 240 -100\n80 -100 80 -200\n";
  EXPECT_EQ(crossingsToGoal(shelf, "0 160 -84"), std::nullopt) << "100 units up, and no way round";
  const std::string step = "20 -150 60 -150\n";
  EXPECT_EQ(crossingsToGoal(shelf + step, "0 160 -84"), 0) << "a step on the way";
}

TEST(ReachTest, AGapTooWideToJumpIsNoWay) {
  const auto crossings = [](int right) {
    const auto level =
        cubeLevel("0 -200 0 0", {"-240 -20 -160 -20\n" + std::to_string(right) + " -20 240 -20"}, "0 220 -4");
    return Reach(*level, 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(-20), 0) << "140 units";
  EXPECT_EQ(crossings(80), std::nullopt) << "240 units";
}

// A line of a level text; `side` −1 mirrors it.
std::string lineOf(int side, int x0, int y0, int x1, int y1) {
  return std::to_string(side * x0) + " " + std::to_string(y0) + " " + std::to_string(side * x1) + " " +
         std::to_string(y1) + "\n";
}

// The ramp goes from edge to edge, so that nobody gets to an end of it.
TEST(ReachTest, ASlideDownASteepSegmentLeadsOverAWiderGap) {
  const auto crossings = [](int side, const std::string& ramp) {
    const std::string start = "0 " + std::to_string(side * -150) + " 150 0";
    const std::string goal = "0 " + std::to_string(side * 220) + " -184";
    return Reach(*cubeLevel(start, {lineOf(side, 175, -200, 240, -200) + ramp}, goal), 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(1, ""), std::nullopt);
  EXPECT_EQ(crossings(1, lineOf(1, -190, 240, -190, -240)), std::nullopt) << "nobody slides down a wall";
  for (const int side : {1, -1}) EXPECT_EQ(crossings(side, lineOf(side, -239, 239, 37, -239)), 0) << side;
}

// Who has slid down a ramp to a floor is faster than a run for some ticks.
TEST(ReachTest, AJumpAfterASlideLeadsOverAWiderGap) {
  const auto crossings = [](const std::string& ramp, int right) {
    const std::string floors = "0 -120 20 -120\n" + std::to_string(right) + " -120 498 -120\n";
    const std::string goal = std::to_string(right + 40) + " -104";
    return Reach(*levelOf("HEXAHEDRON\n0 -380 430 0\n0 " + goal + "\n1000\n%\n" + ramp + floors + "%\n%\n%\n%\n%\n"), 0)
        .crossingsToGoal();
  };
  EXPECT_EQ(crossings("-400 400 0 -120\n", 300), 0);
  EXPECT_EQ(crossings("-400 400 0 -120\n", 360), std::nullopt);
}

TEST(ReachTest, WhatIsNotTouchedOpensNothing) {
  const auto level =
      cubeLevel("0 0 -180 0", {kFlat + kRoom + "-100 -180 -100 -160 key 1\n-60 -200 -20 -200 plate 1\n"}, "0 160 -184");
  const ElementWord key{ElementKind::kKey, 1};
  const ElementWord plate{ElementKind::kPlate, 1};
  EXPECT_EQ(Reach(*level, 0, {key}).crossingsToGoal(), 0);
  EXPECT_EQ(Reach(*level, 0, {plate}).crossingsToGoal(), 0);
  EXPECT_EQ(Reach(*level, 0, {key, plate}).crossingsToGoal(), std::nullopt);
}

// The checkpoint reaches through a wall, and the hazard brings the player to its middle.
TEST(ReachTest, ACheckpointThatIsNotTouchedLeadsNobodyBack) {
  const auto level = cubeLevel(
      "0 0 -180 0",
      {kFlat + "60 -200 60 0\n60 0 240 0\n240 0 240 -200\n20 -180 220 -180 checkpoint\n" + "-100 -200 -60 -200 hazard"},
      "0 160 -150");
  EXPECT_EQ(Reach(*level, 0).crossingsToGoal(), 0);
  EXPECT_EQ(Reach(*level, 0, {{ElementKind::kCheckpoint}}).crossingsToGoal(), std::nullopt);
}

TEST(ReachTest, ADoorThatNothingOpensStaysShutForSeveralPlayersToo) {
  const auto reaches = [](const std::string& lines) {
    const auto level = levelOf("# players: 2\nHEXAHEDRON\n0 0 -180 0\n0 160 -184\n480\n%\n" + kFlat + kRoom + lines +
                               "%\n%\n%\n%\n%\n");
    return Reach(*level, 0).crossingsToGoal();
  };
  EXPECT_EQ(reaches(""), std::nullopt);
  EXPECT_EQ(reaches("50 -100 60 -100 plate 1\n"), 0) << "wherever the plate is";
}

TEST(ReachTest, ACrossingIsCounted) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat, kFlat, kFlat}, "2 0 -184");
  EXPECT_EQ(Reach(*level, 3).crossingsToGoal(), 2);
  EXPECT_EQ(Reach(*level, 1).crossingsToGoal(), std::nullopt);
}

TEST(ReachTest, ADoorIsNoWayWithoutItsKey) {
  EXPECT_EQ(crossingsToGoal(kRoom, "0 160 -184", 0), std::nullopt);
  EXPECT_EQ(crossingsToGoal(kRoom + "-100 -180 -100 -160 key 2", "0 160 -184", 0), std::nullopt);
  EXPECT_EQ(crossingsToGoal(kRoom + "-100 -180 -100 -160 key 1", "0 160 -184", 0), 0);
}

TEST(ReachTest, AHazardIsNoGround) {
  const std::string pit = "-240 -20 -160 -20\n-160 -20 -160 -200\n100 -20 240 -20\n100 -20 100 -200\n";
  const auto crossings = [&](const std::string& floor) {
    return Reach(*cubeLevel("0 -200 0 0", {pit + "-160 -60 100 -60" + floor}, "0 220 -4"), 0).crossingsToGoal();
  };
  EXPECT_EQ(crossings(""), 0);
  EXPECT_EQ(crossings(" hazard"), std::nullopt);
}

TEST(ReachTest, APlayerStandsOnThePostAtACorner) {
  const auto level = cubeLevel("0 235 -227 0", {}, "0 225 -185");
  PlayedGame played(level);
  played.run(20, kNone);
  EXPECT_TRUE(played.grounded());
  played.run(20, Input::kJump);
  EXPECT_TRUE(played.player().finished());
  EXPECT_EQ(Reach(*level, 2).crossingsToGoal(), 0);
}

TEST(ReachTest, APlayerStandsBetweenASteepSegmentAndAWall) {
  const auto level = cubeLevel("0 14 -150 0", {"0 0 0 -200\n0 -200 100 -30.2"}, "0 14 -105");
  PlayedGame played(level);
  played.run(30, kNone);
  EXPECT_TRUE(played.grounded());
  played.run(20, Input::kJump);
  EXPECT_TRUE(played.player().finished());
  EXPECT_EQ(Reach(*level, 2).crossingsToGoal(), 0);
}

// The place before the door is visited without a crossing, when the door is still shut.
TEST(ReachTest, WhoComesBackWithAKeyGoesThroughTheDoor) {
  const std::string key = "0 -180 0 -160 key 1\n";
  const auto level = cubeLevel("0 0 -180 0", {kFlat + kRoom, "", "", kFlat + key}, "0 160 -184");
  EXPECT_EQ(Reach(*level, 4).crossingsToGoal(), 2);
}

const std::string kTrap = "-240 -200 240 -200 hazard\n200 -180 200 -150 key 1\n";

TEST(ReachTest, WhoTookAKeyBehindAHazardGoesOnFromTheStart) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat + kRoom, "", "", kTrap}, "0 160 -184");
  EXPECT_EQ(Reach(*level, 4).crossingsToGoal(), 1);
}

// The start is an edge farther away from the room, whose roof is the way to the key.
TEST(ReachTest, WhoTookAKeyBehindAHazardGoesOnFromTheCheckpointBeforeIt) {
  const auto crossings = [](const std::string& checkpoint) {
    const std::string room = "60 -200 60 -140 door 1\n60 -140 200 -140\n200 -140 200 -200\n214 -172 236 -172\n";
    const auto level = cubeLevel("1 0 -180 0", {kFlat + room + checkpoint, kFlat, "", kTrap}, "0 130 -184");
    return Reach(*level, 4).crossingsToGoal();
  };
  EXPECT_EQ(crossings(""), 3);
  EXPECT_EQ(crossings("-100 -185 -100 -180 checkpoint\n"), 2);
}

// Only the first numbers are told apart. Doors of others are open from the start, which allows more, not less.
TEST(ReachTest, DoorsOfManyNumbersAreOpenFromTheStart) {
  std::string doors;
  std::string keys;
  for (int number = 0; number <= Reach::kMaxNumbers; ++number) {
    doors += std::to_string(60 + number) + " -200 " + std::to_string(60 + number) + " -20 door " +
             std::to_string(number) + "\n";
    keys += "0 -180 0 -160 key " + std::to_string(number) + "\n";
  }
  const std::string room = "60 -20 240 -20\n";
  const auto crossings = [&](const std::string& lines, const std::string& more) {
    return Reach(*cubeLevel("0 0 -180 0", {kFlat + room + lines, "", "", kFlat + more}, "0 160 -184"), 2)
        .crossingsToGoal();
  };
  EXPECT_EQ(crossings(doors, keys), 2);
  EXPECT_EQ(crossings("60 -200 60 -20 door 4\n", "0 -180 0 -160 key 4\n"), 2);
}

}  // namespace
}  // namespace platon::reach_test
