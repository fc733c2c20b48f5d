// Largest coordinates, velocities, segments and shapes.
#include <gtest/gtest.h>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"

namespace platon::hard_cases::limits_test {
namespace {

constexpr std::int32_t kLast = kCoordinateLimit - 1;
constexpr std::int32_t kFastest = kVelocityLimit - 1;

// Displacements, segments and shapes of the largest size, all at once.
TEST(LimitsTest, SweepsWithTheLargestNumbersAreExact) { EXPECT_EQ(expectAnswers("limits/extremes"), 18u); }

TEST(LimitsTest, StopsBetweenTheLongestSegments) {
  HardScene scene("limits/range.scene");
  const WorldState start = scene.world.save();
  for (std::int32_t quarter = 0; quarter < 4; ++quarter) {
    const Angle turn = Angle::degrees(90 * quarter);
    WorldState placed = start;
    placed.entities[0].position = rotate(start.entities[0].position, turn);
    scene.world.restore(placed);
    EXPECT_EQ(scene.ticksUntilRest(rotate(scene.velocity, turn), 10), 2);
    EXPECT_EQ(scene.at(), rotate(Point(20, 0), turn)) << "both front vertices are on the diagonals";
    for (int tick = 0; tick < 1000; ++tick) scene.tick(rotate(scene.velocity, turn));
    EXPECT_EQ(scene.at(), rotate(Point(20, 0), turn));
    scene.tick(rotate(Point(kFastest, 0), turn));
    EXPECT_EQ(scene.at(), rotate(Point(20 + kFastest, 0), turn));
    scene.tick(rotate(Point(kFastest, 0), turn));
    EXPECT_EQ(scene.at(), rotate(Point(kLast, 0), turn)) << "19 subunits farther would be out of range";
  }
}

TEST(LimitsTest, StopsAtTheOutermostSegments) {
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      HardScene scene("limits/border.scene");
      EXPECT_EQ(scene.ticksUntilRest({x * kFastest, y * kFastest}, 10), x == 0 && y == 0 ? 0 : 2);
      EXPECT_EQ(scene.at(), Point(x * (kLast - 10), y * (kLast - 10)));
    }
  }
}

TEST(LimitsTest, StopsAtTheEndOfTheCoordinateRange) {
  HardScene scene("limits/open.scene");
  const Point start[] = {{kLast, 0}, {kLast - 1, kLast}, {-kLast, -kLast}};
  scene.tick({kFastest, 0});
  EXPECT_EQ(scene.at(0), start[0]);
  EXPECT_EQ(scene.at(1), Point(kLast, kLast));
  EXPECT_EQ(scene.at(2), Point(-kLast + kFastest, -kLast));
  for (int tick = 0; tick < 5; ++tick) scene.tick({-kFastest, -kFastest});
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(scene.at(i).y, -kLast) << i;
  EXPECT_TRUE(scene.invariantsHold());
}

TEST(LimitsTest, ALargeShapeSlidesOnTheLongestSegment) {
  HardScene scene("limits/largest.scene");
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(-kVelocityLimit + kFastest, 0));
  scene.tick(scene.velocity);
  EXPECT_EQ(scene.at(), Point(-kVelocityLimit + 2 * kFastest, 0));
  EXPECT_EQ(scene.rules.contacts.size(), 1u);
  EXPECT_EQ(scene.rules.contacts[0].segment.index, 0u);
}

}  // namespace
}  // namespace platon::hard_cases::limits_test
