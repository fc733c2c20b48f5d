// Velocities from zero to many faces per tick.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "platon/exact/integer.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::velocities_test {
namespace {

TEST(VelocitiesTest, ZeroVelocityMovesNothing) {
  HardScene scene("velocities/still.scene");
  const WorldState before = scene.world.save();
  scene.tick(scene.velocity);
  const std::uint64_t hash = scene.world.hash();
  for (int tick = 0; tick < 1000; ++tick) scene.tick(scene.velocity);
  EXPECT_EQ(scene.world.hash(), hash);
  EXPECT_EQ(scene.at(), before.entities[0].position);
  EXPECT_TRUE(scene.rules.take().empty()) << "a touch is not a contact";
}

TEST(VelocitiesTest, OneSubunitPerTickReachesTheWall) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      HardScene scene("velocities/one.scene");
      for (int tick = 1; tick <= 1000; ++tick) {
        scene.tick({x, y});
        ASSERT_EQ(scene.at(), Point(tick * x, tick * y));
        ASSERT_TRUE(scene.rules.contacts.empty());
      }
      for (int tick = 0; tick < 100; ++tick) scene.tick({x, y});
      EXPECT_EQ(scene.at(), Point(1000 * x, 1000 * y));
      EXPECT_EQ(scene.rules.contacts.empty(), x == 0 && y == 0);
    }
  }
}

/// A closed straight path around a solid, along the x axis of the start face.
struct RoundTrip {
  const char* level;
  int crossings;
  double edges;  ///< length of the path, in edge lengths
};

// The unfolded tetrahedron is a lattice of triangles that repeats after two edges. The octahedron and the icosahedron
// have straight belts of 6 and 10 triangles. On the dodecahedron the path is the regular decagon halfway between two
// opposite faces: it passes the middles of ten edges, and its sides are half as long as a diagonal of a face.
const RoundTrip kRoundTrips[] = {{"tetrahedron", 4, 2},
                                 {"hexahedron", 4, 4},
                                 {"octahedron", 6, 3},
                                 {"dodecahedron", 10, 5 * std::numbers::phi},
                                 {"icosahedron", 10, 5}};

// Bound of the error in subunits. Every crossing rounds the remaining displacement, by up to 0.71 subunits, and the
// position of the new home instance, by up to 0.71 more. The roundings are independent, so they add up like a square
// root.
double maxError(int crossings) { return 1 + 3 * std::sqrt(crossings * 0.5); }

void expectRoundTrip(const RoundTrip& trip, int ticks, int rounds) {
  HardLevel level("velocities/" + std::string(trip.level) + ".level");
  ASSERT_TRUE(level.placeAtStart());
  const double length = trip.edges * level.level->faceSize * kSubunitsPerUnit * rounds;
  for (int tick = 0; tick < ticks; ++tick) {
    const double from = std::round(length * tick / ticks);
    level.push({static_cast<std::int32_t>(std::round(length * (tick + 1) / ticks) - from), 0});
  }
  EXPECT_EQ(level.entity().part(), level.level->startFace);
  EXPECT_EQ(level.entity().rotation(), Angle());
  EXPECT_EQ(level.entity().state().crossings, static_cast<std::uint32_t>(trip.crossings * rounds));
  const Point error = level.at() - level.level->start;
  EXPECT_LE(std::hypot(error.x, error.y), maxError(trip.crossings * rounds) + 0.71 * std::sqrt(ticks));
  EXPECT_TRUE(level.rules.contacts.empty());
}

TEST(VelocitiesTest, ReturnsToTheStartAtOneFacePerTick) {
  for (const RoundTrip& trip : kRoundTrips) {
    SCOPED_TRACE(trip.level);
    expectRoundTrip(trip, trip.crossings, 1);
    expectRoundTrip(trip, trip.crossings * 5, 5);
  }
}

TEST(VelocitiesTest, ReturnsToTheStartAtManyFacesPerTick) {
  for (const RoundTrip& trip : kRoundTrips) {
    for (const int rounds : {1, 2, 5}) {
      SCOPED_TRACE(trip.level + std::string(", rounds ") + std::to_string(rounds));
      expectRoundTrip(trip, 1, rounds);
    }
  }
}

// They are below the limit in every frame.
TEST(VelocitiesTest, InvariantsHoldAtTheLargestVelocity) {
  for (const RoundTrip& trip : kRoundTrips) {
    for (const Point velocity :
         {Point(kVelocityLimit - 1, 0), Point(-230000000, 123456789), Point(12345, 10 - kVelocityLimit)}) {
      HardLevel level("velocities/" + std::string(trip.level) + ".level");
      ASSERT_TRUE(level.placeAtStart());
      for (int tick = 0; tick < 10; ++tick) level.push(velocity);
      EXPECT_TRUE(level.invariantsHold()) << trip.level;
      EXPECT_GT(level.entity().state().crossings, 10u) << trip.level;
    }
  }
}

}  // namespace
}  // namespace platon::hard_cases::velocities_test
