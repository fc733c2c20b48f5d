#include "client/demo/goal_distance.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/support/test_level.h"

namespace platon::goal_distance_test {
namespace {

TEST(GoalDistance, IsSmallAtTheGoalAndGrowsWithDistance) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  const auto unit = kSubunitsPerUnit;
  EXPECT_LT(distance.from({level->goalFace, level->goal}), 20 * unit);
  const std::int32_t fromStart = distance.from({level->startFace, level->start});
  EXPECT_GT(fromStart, 300 * unit);
  EXPECT_LT(fromStart, 360 * unit);
}

TEST(GoalDistance, CrossesEdgesButNotSegments) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  for (const std::uint32_t face : {1u, 2u, 3u, 4u}) {
    const std::int32_t value = distance.from({face, Point(0, 0)});
    EXPECT_GT(value, 240 * kSubunitsPerUnit) << "face " << face;
    EXPECT_LT(value, 1200 * kSubunitsPerUnit) << "face " << face;
  }
  EXPECT_EQ(distance.from({5, Point(0, 0)}), GoalDistance::kUnreachable);
}

// Along a straight path across the floor from the start, the distance decreases towards the goal.
TEST(GoalDistance, DecreasesTowardsTheGoal) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  std::int32_t last = distance.from({level->goalFace, level->start});
  for (std::int32_t x = -100; x <= 100; x += 50) {
    const std::int32_t next = distance.from({level->goalFace, Point(x * kSubunitsPerUnit, level->start.y)});
    EXPECT_LT(next, last) << x;
    last = next;
  }
}

// A room on face 0, from x = -220 to 220 and from y = -200 to -100, with the goal at its right end.
std::shared_ptr<const Level> roomWith(const std::string& segments) {
  const LevelResult result = loadLevel(
      "HEXAHEDRON\n0 -150 -180 0\n0 160 -180\n480\n%\n"
      "-220 -200 220 -200\n220 -200 220 -100\n220 -100 -220 -100\n-220 -100 -220 -200\n" +
      segments + "\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

std::int32_t fromStart(const std::string& segments, std::uint32_t open = 0) {
  const auto level = roomWith(segments);
  return GoalDistance(*level).from({level->startFace, level->start}, open);
}

TEST(GoalDistance, ElementsThatCanBePassedAreNotInTheWay) {
  const std::int32_t plain = fromStart("");
  EXPECT_LT(plain, 360 * kSubunitsPerUnit);
  // The left of a segment that leads down is on the right.
  for (const char* wall : {"0 -100 0 -200 oneway", "0 -200 0 -100 up 1", "0 -200 0 -100 checkpoint"})
    EXPECT_EQ(fromStart(wall), plain) << wall;
}

TEST(GoalDistance, HazardsPlatesAndClosedDoorsAreInTheWay) {
  for (const char* wall : {"0 -200 0 -100", "0 -200 0 -100 hazard", "0 -200 0 -100 plate 3", "0 -200 0 -100 door 3",
                           "0 -200 0 -100 oneway"}) {
    EXPECT_EQ(fromStart(wall), GoalDistance::kUnreachable) << wall;
  }
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3", 1u << 3), fromStart(""));
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3", 1u << 2), GoalDistance::kUnreachable);
}

// The way to the key and from there through the door, until the key is taken.
TEST(GoalDistance, AKeyIsOnTheWayToItsDoor) {
  const std::string segments = "0 -200 0 -100 door 3\n-200 -180 -200 -160 key 3";
  const std::int32_t plain = fromStart("");
  const std::int32_t withKey = fromStart(segments);
  EXPECT_GT(withKey, plain + 60 * kSubunitsPerUnit);
  EXPECT_LT(withKey, plain + 160 * kSubunitsPerUnit);
  EXPECT_EQ(fromStart(segments, 1u << 3), plain);
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3\n50 -180 50 -160 key 3"), GoalDistance::kUnreachable)
      << "the key is behind its door";
}

}  // namespace
}  // namespace platon::goal_distance_test
