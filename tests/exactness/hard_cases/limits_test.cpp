// Largest coordinates, velocities, segments and shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/hard_cases/sweep_cases.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/support/run/repetitions.h"

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

// A point on the border of the coordinates, at most `away` subunits from `middle` along each axis.
Point pointNear(oracle::RandomSource& random, Point middle, std::int64_t away) {
  const auto near = [&](std::int32_t value) {
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(value + random.between(-away, away), -std::int64_t{kLast}, kLast));
  };
  return {near(middle.x), near(middle.y)};
}

// A body at a side or a corner of the coordinates is pushed outwards and along, beside a segment that may lead out. Its
// ideal place may be out of range, which once made a step endless.
TEST(LimitsTest, EveryStepAtTheLimitEnds) {
  properties::forEachCase(repetitions(2000), [](oracle::RandomSource& random) {
    const Point side(1, static_cast<std::int32_t>(random.between(-1, 1)));
    const Point middle(kLast, side.y * kLast);
    const auto size = static_cast<std::int32_t>(random.between(1, 30));
    const Convex shape = random.oneIn(2) ? Convex({{0, -size}, {size, 0}, {0, size}, {-size, 0}})
                                         : Convex({{-size, -size}, {size, -size / 2}, {0, size}});
    World world;
    MapPart part(world, 0);
    const std::int64_t away = random.oneIn(2) ? 40 : 2000;
    part.line(pointNear(random, middle, away), pointNear(random, middle, away));
    part.initialize();
    Entity body(world, shape);
    try {
      part.insert(body, pointNear(random, middle, 4), Angle());
    } catch (const std::invalid_argument&) {
      return;  // on the segment
    }
    CheckedWorld scene("limits", world, {.shape = shape});
    const std::int32_t speed = random.oneIn(2) ? 60 : 4000;
    const auto push = [&](std::int32_t towards) {
      return static_cast<std::int32_t>(random.between(-speed, speed) + towards * random.between(0, speed));
    };
    for (int tick = 0; tick < 40; ++tick) {
      scene.tick({push(side.x), push(side.y)});
      ASSERT_TRUE(isCoordinate(scene.at().x) && isCoordinate(scene.at().y));
    }
  });
}

}  // namespace
}  // namespace platon::hard_cases::limits_test
