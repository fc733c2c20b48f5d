#include "client/demo/goal_distance.h"

#include <gtest/gtest.h>

#include "tests/support/test_level.h"

namespace platon {
namespace {

TEST(GoalDistance, IsSmallAtTheGoalAndGrowsWithDistance) {
  const auto level = flatLevel();
  const GoalDistance distance(*level);
  const auto unit = kSubunitsPerUnit;
  EXPECT_LT(distance.from({level->goalFace, level->goal}), 20 * unit);
  const std::int32_t fromStart = distance.from({level->startFace, level->start});
  EXPECT_GT(fromStart, 300 * unit);
  EXPECT_LT(fromStart, 360 * unit);
}

TEST(GoalDistance, CrossesEdgesButNotSegments) {
  const auto level = flatLevel();
  const GoalDistance distance(*level);
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
  const GoalDistance distance(*level);
  std::int32_t last = distance.from({level->goalFace, level->start});
  for (std::int32_t x = -100; x <= 100; x += 50) {
    const std::int32_t next = distance.from({level->goalFace, Point(x * kSubunitsPerUnit, level->start.y)});
    EXPECT_LT(next, last) << x;
    last = next;
  }
}

}  // namespace
}  // namespace platon
