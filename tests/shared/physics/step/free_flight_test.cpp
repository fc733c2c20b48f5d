// The usual step: flyFreely.
#include <gtest/gtest.h>

#include <cstdint>

#include "platon/exact/integer.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/tolerances.h"
#include "tests/shared/physics/step/step_parts.h"
#include "tests/shared/physics/torus.h"
#include "tests/support/run/repetitions.h"

namespace platon::free_flight_test {
namespace {

class FreeFlightTest : public StepParts {
 protected:
  // A body at the origin with this velocity; walls at x = `wall` and, where the part has one, a warp at x = -5000.
  void place(std::int32_t wall, Point velocity) {
    build({{{wall, -500}, {wall, 500}}});
    state_.velocity = velocity;
    regions_.resize(1);
  }
  bool fly() { return flyFreely(state_, instances_, regions_, work_); }
};

TEST_F(FreeFlightTest, GoesToTheLatticePointNearestToTheIdealPlace) {
  place(5000, {30, -7});
  state_.heading = Angle(3000);
  state_.remainder = Point(1 << 24, -(1 << 24));
  const PrecisePoint ideal = rotatePrecise({30, -7}, rotationOf(Angle(3000))) + PrecisePoint{1 << 24, -(1 << 24)};
  ASSERT_TRUE(fly());
  EXPECT_EQ(state_.position, rounded(ideal));
  EXPECT_EQ(precise(state_.position) + (PrecisePoint{state_.remainder.x, state_.remainder.y}), ideal);
  EXPECT_EQ(instances_.home().position, state_.position);
  EXPECT_EQ(state_.fresh, 0);
}

TEST_F(FreeFlightTest, NothingIsNearFartherThanTheTolerance) {
  // The square reaches 10 subunits beyond its position.
  place(10 + 20 + Tolerances::kNear, {20, 0});
  EXPECT_TRUE(fly());
  place(10 + 20 + Tolerances::kNear - 1, {20, 0});
  const EntityState before = state_;
  EXPECT_FALSE(fly());
  EXPECT_EQ(state_, before);
  EXPECT_EQ(instances_.home().position, before.position);
}

TEST_F(FreeFlightTest, OtherCasesAreLeftToTheWholeStep) {
  place(5000, {20, 0});
  state_.turn = 1;
  EXPECT_FALSE(fly()) << "a rotation";
  place(5000, {});
  EXPECT_FALSE(fly()) << "a body that rests";
  place(5000, {20, 0});
  state_.remainder = Point(1 << 25, 0);
  EXPECT_FALSE(fly()) << "two lattice points are equally near";
  place(5000, {kCoordinateLimit / 4, 0});
  EXPECT_FALSE(fly()) << "near the coordinate limit";
}

// A world without an observer may fly freely, one with an observer does not.
class Watcher : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override {}
};

TEST(FreeFlightLawTest, IsAWholeStep) {
  const int worlds = repetitions(200);
  sim::SeededRandom random(20261128);
  Watcher watcher;
  for (int number = 0; number < worlds; ++number) {
    World world;
    for (std::uint32_t part = 0; part < kTorusParts; ++part) addTorusPart(world, part, random);
    for (std::uint32_t i = 0; i < 8; ++i) {
      Entity entity(world, randomConvex(random, 2 + static_cast<std::int32_t>(random.below(60))));
      try {
        MapPart(world, i % 4).insert(entity, random.vector(kTorusReach), Angle());
      } catch (const std::invalid_argument&) {  // not free there
      }
    }
    World watched = world;
    for (int tick = 0; tick < 60; ++tick) {
      if (tick % 10 == 0) {
        WorldState state = world.save();
        for (EntityState& entity : state.entities) {
          if (entity.inserted == 0) continue;
          entity.velocity = random.vector(random.below(2) == 0 ? 3 : 300);
          // Also exactly between two lattice points.
          entity.heading = Angle(static_cast<std::int32_t>(random.below(2) * random.below(Angle::kTurn)));
          const Point halves = random.vector(15);
          entity.remainder =
              random.below(2) == 0 ? Point(halves.x * (1 << 25), halves.y * (1 << 25)) : random.vector(kRemainderLimit);
          entity.turn = random.below(4) == 0 ? 100 : 0;
        }
        if (!world.accepts(state)) continue;
        world.restore(state);
        watched.restore(state);
      }
      world.solve();
      watched.solve(&watcher);
      ASSERT_EQ(world.hash(), watched.hash()) << "world " << number << ", tick " << tick;
    }
  }
}

}  // namespace
}  // namespace platon::free_flight_test
