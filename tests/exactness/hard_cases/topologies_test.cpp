// Segments that continue, cover, repeat or cross each other: the same geometry in other pieces gives the same motion.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::topologies_test {
namespace {

std::vector<Point> pathIn(const std::string& name, int ticks) {
  HardScene scene("topologies/" + name + ".scene");
  std::vector<Point> path;
  for (int tick = 0; tick < ticks; ++tick) {
    scene.tick(scene.velocity);
    path.push_back(scene.at());
  }
  return path;
}

TEST(TopologiesTest, ASlopeInPiecesIsTheSameSlope) {
  const std::vector<Point> expected = pathIn("single", 60);
  EXPECT_GT(expected.back().x, 100000) << "does not slide up";
  for (const char* name : {"collinear", "overlapping", "duplicated", "stems", "points_on_it"}) {
    EXPECT_EQ(pathIn(name, 60), expected) << name;
  }
}

TEST(TopologiesTest, AFloorOfPointsIsAFloor) {
  const std::vector<Point> expected = pathIn("flat", 120);
  EXPECT_EQ(expected.back(), Point(50000, 9000));
  EXPECT_EQ(pathIn("points", 120), expected);
}

TEST(TopologiesTest, CrossingSegmentsMaySplitAtTheCrossing) {
  const std::vector<Point> expected = pathIn("crossing", 200);
  EXPECT_EQ(expected[100], expected.back()) << "not at rest in the notch";
  EXPECT_EQ(pathIn("quarters", 200), expected);
}

// At velocities that lead down both slopes the entity rests where the slopes cross (I4).
TEST(TopologiesTest, RestsWhereSegmentsCross) {
  HardScene scene("topologies/crossing.scene");
  scene.ticksUntilRest({0, -1500}, 500);
  const WorldState settled = scene.world.save();
  int restless = 0;
  for (const std::int32_t speed : {30, 1581, 20000, 1000000}) {
    for (std::int32_t angle = 25200; angle < 30350; angle += 50) {
      scene.world.restore(settled);
      const Point velocity = rotate(Point(speed, 0), Angle(angle));
      for (int tick = 0; tick < 100; ++tick) scene.tick(velocity);
      const Point rest = scene.at();
      restless += scene.ticksUntilRest(velocity, 3) != 0;
      EXPECT_TRUE(restless != 1 || scene.at() == rest)
          << "velocity " << testing::PrintToString(velocity) << ": from " << testing::PrintToString(rest) << " to "
          << testing::PrintToString(scene.at());
    }
  }
  EXPECT_EQ(restless, 0) << "number of the 412 velocities at which the entity does not rest";
}

TEST(TopologiesTest, RestsBetweenAWallAndAFloor) {
  HardScene scene("topologies/wall.scene");
  scene.ticksUntilRest(scene.velocity, 100);
  EXPECT_EQ(scene.at(), Point(60000 - 9000, 9000));
  scene.ticksUntilRest({-scene.velocity.x, scene.velocity.y}, 100);
  EXPECT_EQ(scene.at(), Point(-90000 + 9000, 9000)) << "where the wall crosses the floor";
}

// An entity moves towards the centre from every 10 degrees. The ends of the segments are 157 subunits apart. Between
// two segments a square of 6 subunits fits up to a distance of 1 910 from the centre.
TEST(TopologiesTest, RestsBetweenAThousandSegmentsThroughOnePoint) {
  HardScene scene("topologies/star.scene");
  const WorldState start = scene.world.save();
  for (std::int32_t degrees = 0; degrees < 360; degrees += 10) {
    scene.world.restore(start);
    const Angle turn = Angle::degrees(degrees);
    WorldState placed = start;
    placed.entities[0].position = rotate(scene.at(), turn);
    scene.world.restore(placed);
    ASSERT_LT(scene.ticksUntilRest(rotate(scene.velocity, turn), 200), 200) << degrees << " degrees";
    const Point rest = scene.at();
    EXPECT_GE(squaredLength(rest), std::int64_t{1900} * 1900) << degrees << " degrees";
    for (int tick = 0; tick < 50; ++tick) scene.tick(rotate(scene.velocity, turn));
    ASSERT_EQ(scene.at(), rest) << degrees << " degrees";
    scene.tick(rotate(Point(60000, 0), turn));
    EXPECT_GE(squaredLength(scene.at()), std::int64_t{50000} * 50000) << degrees << " degrees: moving away";
    ASSERT_TRUE(scene.invariantsHold());
  }
}

}  // namespace
}  // namespace platon::hard_cases::topologies_test
