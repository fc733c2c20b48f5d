// Floors that continue over the edges of a solid: sliding along them (I3) and resting on them (I4).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shared/game/player.h"
#include "shared/game/solid.h"
#include "shared/game/stage.h"
#include "shared/physics/entity.h"
#include "shared/physics/map_part.h"
#include "shared/physics/world.h"
#include "tests/shared/game/real_face.h"
#include "tests/shared/physics/leg_checker.h"

namespace platon {
namespace {

constexpr std::int32_t kSize = 480;
constexpr double kReach = 60000;   // of the floor to either side of the edge

// A straight floor over one edge; a walker's right is along it.
struct Floor {
  SolidKind kind;
  int face;
  int edge;
  double along;   // the edge
  double slant;   // of the floor from straight over the edge, degrees

  RealFace ideal() const { return {kind, kSize}; }
  Real crossing() const { return ideal().onEdge(edge, along); }
  Real direction() const { return turned(ideal().outwards(edge), Angle(static_cast<std::int32_t>(slant * 100))); }
  Real up() const { return left(direction()); }
  std::uint32_t behind() const { return PlatonicSolid::of(kind).neighbour(face, edge).face; }
  /// A position in the frame of `face` as if all were in one plane.
  Real unfolded(const Entity& entity) const {
    const Real at = real(entity.position());
    if (entity.part() == static_cast<std::uint32_t>(face)) return at;
    const PlatonicSolid::Neighbour& next = PlatonicSolid::of(kind).neighbour(face, edge);
    return ideal().over(next.face, next.edge, at);
  }
  World build() const {
    std::vector<std::vector<Segment>> lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
    const auto over = [&](Real point) { return nearest(ideal().over(face, edge, point)); };
    lines[static_cast<std::size_t>(face)] = {{nearest(crossing() - kReach * direction()), nearest(crossing())}};
    lines[behind()] = {{over(crossing() + kReach * direction()), over(crossing())}};
    return buildStage(kind, kSize, lines);
  }
  std::string name() const {
    return std::string(nameOf(kind)) + ", face " + std::to_string(face) + ", edge " + std::to_string(edge) + " at " +
           std::to_string(along) + ", slant " + std::to_string(slant);
  }
};

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

Angle alignedWith(const Floor& floor) { return directionOf(floor.direction()); }

// Puts the ball down `before` subunits before the edge and lets it come to rest.
Entity settle(World& world, const Floor& floor, double before, Angle angle) {
  Entity entity(world, playerShape());
  const Real start = floor.crossing() - before * floor.direction() + 12400.0 * floor.up();
  MapPart(world, static_cast<std::uint32_t>(floor.face)).insert(entity, nearest(start), angle);
  // Beyond the edge, home is in the part behind it from the beginning.
  entity.setVelocity(rotate(nearest(-256 * floor.up()), entity.rotation() - angle));
  for (int tick = 0; tick < 10; ++tick) world.solve();
  return entity;
}

void expectSmooth(const Floor& floor, Angle angle, double press) {
  World world = floor.build();
  Entity entity = settle(world, floor, 45000, angle);
  LegChecker checker(world);
  const auto height = [&] { return dot(floor.unfolded(entity) - floor.crossing(), floor.up()); };
  const auto progress = [&] { return dot(floor.unfolded(entity) - floor.crossing(), floor.direction()); };
  const double settled = height();
  entity.setVelocity(nearest(4096 * floor.direction() - press * floor.up()));
  for (int tick = 0; tick < 21; ++tick) {
    const double before = progress();
    world.solve(&checker);
    ASSERT_GE(progress() - before, 4096 * 0.99) << floor.name() << ", tick " << tick << ", turned " << angle.hundredths();
    // Three for the step, and what the rounded ends of the floor put it off its straight line.
    ASSERT_LE(std::abs(height() - settled), 3.5) << floor.name() << ", tick " << tick << ", turned " << angle.hundredths();
  }
  ASSERT_EQ(entity.part(), floor.behind());
  ASSERT_EQ(checker.faults(), "") << floor.name();
}

TEST(FloorOverEdgeTest, RunningOverNeitherSlowsNorLifts) {
  forEachFloor([](const Floor& floor) {
    expectSmooth(floor, alignedWith(floor), 256);
    expectSmooth(floor, Angle(1234), 256);
  });
}

TEST(FloorOverEdgeTest, AHardPressMakesNoDifference) {
  forEachFloor([](const Floor& floor) {
    if (floor.along != 0.5) return;
    expectSmooth(floor, alignedWith(floor), 60);
    expectSmooth(floor, alignedWith(floor), 4000);
  });
}

TEST(FloorOverEdgeTest, RunningBackIsAsSmooth) {
  forEachFloor([](const Floor& floor) {
    World world = floor.build();
    Entity entity = settle(world, floor, 45000, alignedWith(floor));
    entity.setVelocity(nearest(4096 * floor.direction() - 256 * floor.up()));
    for (int tick = 0; tick < 21; ++tick) world.solve();
    const Real there = floor.unfolded(entity);
    entity.setVelocity(rotate(nearest(-4096 * floor.direction() - 256 * floor.up()),
                              entity.rotation() - alignedWith(floor)));
    for (int tick = 0; tick < 21; ++tick) world.solve();
    ASSERT_EQ(entity.part(), static_cast<std::uint32_t>(floor.face)) << floor.name();
    const Real way = floor.unfolded(entity) - there;
    ASSERT_LE(dot(way, floor.direction()), -21 * 4096 * 0.99) << floor.name();
    ASSERT_LE(std::abs(dot(way, floor.up())), 3) << floor.name();
  });
}

// On, before and behind the edge, straight and slanted.
TEST(FloorOverEdgeTest, AtRestOnAnEdgeNothingMoves) {
  forEachFloor([](const Floor& floor) {
    if (floor.along != 0.5 || std::abs(floor.slant) < 15 || floor.face > 3) return;
    for (const double before : {-9000.0, -1.0, 0.0, 2.0}) {
      World world = floor.build();
      settle(world, floor, before, alignedWith(floor));
      for (int tick = 0; tick < 30; ++tick) world.solve();
      const WorldState rest = world.save();
      for (int tick = 0; tick < 100; ++tick) world.solve();
      ASSERT_EQ(world.save(), rest) << floor.name() << ", " << before << " before the edge";
    }
  });
}

TEST(FloorOverEdgeTest, AtRestForLong) {
  for (const SolidKind kind : kAllSolids) {
    const Floor floor{kind, 1, 2, 0.5, 20};
    World world = floor.build();
    settle(world, floor, 700, alignedWith(floor));
    for (int tick = 0; tick < 50; ++tick) world.solve();
    const WorldState rest = world.save();
    for (int tick = 0; tick < 100000; ++tick) world.solve();
    EXPECT_EQ(world.save(), rest) << floor.name();
  }
}

}  // namespace
}  // namespace platon
