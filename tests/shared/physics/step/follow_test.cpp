// The position follows the ideal place.
#include <gtest/gtest.h>

#include <cstdint>

#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "shared/physics/step/stages.h"
#include "tests/shared/physics/plane_scene.h"
#include "tests/shared/physics/shapes.h"
#include "tests/shared/physics/step/step_parts.h"

namespace platon::follow_test {
namespace {

class FollowPlaceTest : public StepParts {
 protected:
  // Follows an ideal place `x`, `y` quarters of a subunit from the position.
  bool followTo(std::int64_t x, std::int64_t y) {
    constexpr std::int64_t kQuarter = PrecisePoint::kOne / 4;
    const PrecisePoint end = precise(step().position()) + PrecisePoint{x * kQuarter, y * kQuarter};
    return followTo(end);
  }
  bool followTo(PrecisePoint end) {
    step().tick = {PrecisePoint::kOne, 0};
    findLeg(step(), {end - precise(step().position())});
    return follow(step(), end, nullptr);
  }
};

TEST_F(FollowPlaceTest, MovesToTheNearestLatticePoint) {
  build({});
  ASSERT_TRUE(followTo(41, -7));
  EXPECT_EQ(step().position(), Point(10, -2));
  EXPECT_EQ(step().moves, 1);
}

TEST_F(FollowPlaceTest, OfPlacesEquallyNearTakesTheOneAhead) {
  build({});
  ASSERT_TRUE(followTo(6, 0));
  EXPECT_EQ(step().position(), Point(2, 0));
}

// A point is in the way of the straight move to the free place (40, 1); (40, 2) is too far away.
TEST_F(FollowPlaceTest, TakesADetourWhereTheStraightWayIsBlocked) {
  build({{{30, -9}, {30, -9}}});
  constexpr std::int64_t kBeside = PrecisePoint::kOne * 3 / 8;
  ASSERT_TRUE(followTo(PrecisePoint{40 * PrecisePoint::kOne, kBeside}));
  EXPECT_EQ(step().position(), Point(40, 1));
  EXPECT_EQ(step().moves, 2);
}

// Segment 1 can be passed from the start only.
class FromTheStart : public Rules {
 public:
  bool pierce(const Entity&, const SegmentRef& segment) const override {
    return segment.index == 1 && segment.position == Point();
  }
};

TEST_F(FollowPlaceTest, ADetourAsksTheRulesBeforeItsSecondMove) {
  build({{{30, -9}, {30, -9}}, {{20, -50}, {20, 50}}});
  FromTheStart rules;
  begin(rules);
  EXPECT_FALSE(followTo(PrecisePoint{40 * PrecisePoint::kOne, PrecisePoint::kOne * 3 / 8}));
  EXPECT_EQ(step().moves, 1);
  EXPECT_LT(step().position().x, 10);
}

TEST_F(FollowPlaceTest, MovesNothingWhereNoPlaceIsNear) {
  build({{{30, -100}, {30, 100}}});
  EXPECT_FALSE(followTo(precise(Point(40, 0))));
  EXPECT_EQ(step().position(), Point());
  EXPECT_TRUE(fallBack(step(), precise(Point(40, 0))));
  EXPECT_EQ(step().position(), Point(20, 0)) << "as far as it can";
  EXPECT_FALSE(fallBack(step(), precise(Point(60, 0))));
}

// In rationals, the body stops at (1/2, 1/2). (0, 1) and (1, 1) are outside of the line and equally near.
TEST(FollowTest, OfPlacesEquallyNearTheOuterOneIsTaken) {
  Scene scene({{{142, -60}, {-158, 40}}}, square(10), {10, 29});
  EXPECT_EQ(scene.step({-20, -60}), Point(1, 1));
}

// The ideal path leads along y = x / 1024 through a corridor as wide as the square, where no lattice point is free. The
// lattice path meets the end of the ceiling.
TEST(FollowTest, WhereNoPlaceIsFreeTheBodyMovesAsFarAsItCan) {
  Scene scene({{{10, -10}, {1034, -9}}, {{-10, 10}, {1014, 11}}}, square(10), {-256, 0});
  WorldState state = scene.world.save();
  state.entities[0].remainder = {0, -static_cast<std::int32_t>(PrecisePoint::kOne / 4)};
  scene.world.restore(state);
  EXPECT_EQ(scene.step({1024, 1}), Point(-20, 0));
  EXPECT_EQ(scene.entity.state().remainder, Point());
}

// The wedge is too narrow for the lattice 32 subunits above the place where the ideal body rests.
TEST(FollowTest, InANarrowWedgeTheIdealPlaceStaysWhereThePositionCannotFollow) {
  Scene scene({{{70, -261}, {5, -7}}, {{-109, 127}, {-112, -82}}}, square(67), {-35, -182});
  for (int tick = 0; tick < 3; ++tick) scene.step({191, 93});
  const EntityState rested = scene.entity.state();
  EXPECT_EQ(rested.position, Point(-37, -172));
  scene.step({191, 93});
  EXPECT_EQ(scene.entity.state(), rested);
}

TEST(FollowTest, OnAFloorThePositionIsTheFreeLatticePointNearestToTheIdealPlace) {
  for (const Point along : {Point(1000, 1), Point(997, 331), Point(600, -599), Point(30, 901)}) {
    const Segment floor{{-20 * along.x, -20 * along.y}, {20 * along.x, 20 * along.y}};
    Scene scene({floor}, square(50), Point(-along.y / 5, along.x / 5));
    const auto isFree = [&](Point place) {  // one corner of the square is the lowest
      const Point lowest = place + Point(along.y > 0 ? 50 : -50, along.x > 0 ? -50 : 50);
      return cross(along, lowest) >= 0;
    };
    for (int tick = 0; tick < 200; ++tick) {
      const Point at = scene.step({37, -61});
      const Point remainder = scene.entity.state().remainder;
      const auto distance = [&](Point place) {
        const PrecisePoint between = precise(place - at) - PrecisePoint{remainder.x, remainder.y};
        return between.x * between.x + between.y * between.y;
      };
      for (int x = -2; x <= 2; ++x) {
        for (int y = -2; y <= 2; ++y) {
          if (!isFree(at + Point(x, y))) continue;
          ASSERT_GE(distance(at + Point(x, y)), distance(at)) << along.x << " " << along.y << ", tick " << tick;
        }
      }
    }
  }
}

}  // namespace
}  // namespace platon::follow_test
