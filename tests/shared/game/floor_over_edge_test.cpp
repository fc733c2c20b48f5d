// Floors that continue across the edges of a solid: sliding without a snag (I3) and resting (I4).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "platon/game/solid.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/shared/game/edge_floor.h"

namespace platon::floor_over_edge_test {
namespace {

template <class Visit>
void forEachFloor(Visit&& visit) {
  for (const SolidKind kind : kAllSolids) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
        for (const double along : {0.4, 0.5, 0.587}) {
          for (const double slant : {-35.0, -12.3, 0.0, 20.0, 40.0}) {
            if (testing::Test::HasFatalFailure()) return;
            visit(Floor{kind, face, edge, along, slant});
          }
        }
      }
    }
  }
}

TEST(FloorOverEdgeTest, RunningKeepsSpeedAndHeight) {
  forEachFloor([](const Floor& floor) {
    expectSmooth(floor, alignedWith(floor), 256);
    expectSmooth(floor, Angle(1234), 256);
  });
}

TEST(FloorOverEdgeTest, TheDownwardPressDoesNotChangeARun) {
  forEachFloor([](const Floor& floor) {
    if (floor.along != 0.5) return;
    expectSmooth(floor, alignedWith(floor), 60);
    expectSmooth(floor, alignedWith(floor), 4000);
  });
}

TEST(FloorOverEdgeTest, RunningBackKeepsSpeedAndHeight) {
  forEachFloor([](const Floor& floor) {
    World world = floor.build();
    Entity entity = settle(world, floor, 45000, alignedWith(floor));
    entity.setVelocity(nearest(4096 * floor.direction() - 256 * floor.up()));
    for (int tick = 0; tick < 21; ++tick) world.solve();
    const Real there = floor.unfolded(entity);
    entity.setVelocity(
        rotate(nearest(-4096 * floor.direction() - 256 * floor.up()), entity.rotation() - alignedWith(floor)));
    for (int tick = 0; tick < 21; ++tick) world.solve();
    ASSERT_EQ(entity.part(), static_cast<std::uint32_t>(floor.face)) << floor.name();
    const Real way = floor.unfolded(entity) - there;
    ASSERT_LE(dot(way, floor.direction()), -21 * 4096 * 0.99) << floor.name();
    ASSERT_LE(std::abs(dot(way, floor.up())), 3) << floor.name();
  });
}

// At rest on, before and behind the edge, on straight and slanted floors.
TEST(FloorOverEdgeTest, APlayerAtRestDoesNotMove) {
  forEachFloor([](const Floor& floor) {
    if (floor.along != 0.5 || std::abs(floor.slant) < 15 || floor.face > 3) return;
    for (const double before : {-9000.0, -1.0, 0.0, 2.0}) {
      World world = floor.build();
      settle(world, floor, before, alignedWith(floor));
      for (int tick = 0; tick < 30; ++tick) world.solve();
      const WorldState rest = world.save();
      for (int tick = 0; tick < 100; ++tick) {
        world.solve();
        ASSERT_EQ(world.save(), rest) << floor.name() << ", " << before << " before the edge, tick " << tick;
      }
    }
  });
}

TEST(FloorOverEdgeTest, APlayerAtRestDoesNotMoveIn100000Ticks) {
  for (const SolidKind kind : kAllSolids) {
    const Floor floor{kind, 1, 2, 0.5, 20};
    World world = floor.build();
    settle(world, floor, 700, alignedWith(floor));
    for (int tick = 0; tick < 50; ++tick) world.solve();
    const WorldState rest = world.save();
    for (int tick = 0; tick < 100000; ++tick) {
      world.solve();
      ASSERT_EQ(world.save(), rest) << floor.name() << ", tick " << tick;
    }
  }
}

}  // namespace
}  // namespace platon::floor_over_edge_test
