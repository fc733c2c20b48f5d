#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/solid.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/game/real_face.h"
#include "tests/shared/physics/step/leg_checker.h"

namespace platon {

inline constexpr std::int32_t kFloorFaceSize = 480;
inline constexpr double kFloorReach = 60000;  // length of the floor on either side of the edge

/// A straight floor across one edge; right is along it.
struct Floor {
  SolidKind kind;
  int face;
  int edge;
  double along;  ///< where the floor crosses the edge: 0 at its first corner, 1 at its second
  double slant;  ///< angle between the floor and the normal of the edge, degrees

  RealFace ideal() const { return {kind, kFloorFaceSize}; }
  Real crossing() const { return ideal().onEdge(edge, along); }
  Real direction() const { return turned(ideal().outwards(edge), Angle(static_cast<std::int32_t>(slant * 100))); }
  Real up() const { return left(direction()); }
  std::uint32_t behind() const { return PlatonicSolid::of(kind).neighbour(face, edge).face; }
  /// The position of the entity in the frame of `face`, with both faces in one plane.
  Real unfolded(const Entity& entity) const {
    const Real at = real(entity.position());
    if (entity.part() == static_cast<std::uint32_t>(face)) return at;
    const PlatonicSolid::Neighbour& next = PlatonicSolid::of(kind).neighbour(face, edge);
    return ideal().over(next.face, next.edge, at);
  }
  World build() const {
    std::vector<std::vector<Segment>> lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
    const auto over = [&](Real point) { return nearest(ideal().over(face, edge, point)); };
    lines[static_cast<std::size_t>(face)] = {{nearest(crossing() - kFloorReach * direction()), nearest(crossing())}};
    lines[behind()] = {{over(crossing() + kFloorReach * direction()), over(crossing())}};
    return buildStage(kind, kFloorFaceSize, lines);
  }
  std::string name() const {
    return std::string(nameOf(kind)) + ", face " + std::to_string(face) + ", edge " + std::to_string(edge) + " at " +
           std::to_string(along) + ", slant " + std::to_string(slant);
  }
};

inline Angle alignedWith(const Floor& floor) { return rotationOf(floor.direction()); }

/// Drops a player `before` subunits before the edge and lets it come to rest.
inline Entity settle(World& world, const Floor& floor, double before, Angle angle) {
  Entity entity(world, playerShape());
  const Real start = floor.crossing() - before * floor.direction() + 12400.0 * floor.up();
  MapPart(world, static_cast<std::uint32_t>(floor.face)).insert(entity, nearest(start), angle);
  // With a start beyond the edge, the home instance is in the part behind it from the beginning.
  entity.setVelocity(rotate(nearest(-256 * floor.up()), entity.rotation() - angle));
  for (int tick = 0; tick < 10; ++tick) world.solve();
  return entity;
}

/// Runs over the edge, pressed to the floor by `press` subunits per tick; expects that the speed and the height stay.
inline void expectSmooth(const Floor& floor, Angle angle, double press) {
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
    ASSERT_GE(progress() - before, 4096 * 0.99)
        << floor.name() << ", tick " << tick << ", turned " << angle.centidegrees();
    // 3 for the step, and 0.5 because the ends of the floor are rounded.
    ASSERT_LE(std::abs(height() - settled), 3.5)
        << floor.name() << ", tick " << tick << ", turned " << angle.centidegrees();
  }
  ASSERT_EQ(entity.part(), floor.behind());
  ASSERT_EQ(checker.faults(), "") << floor.name();
}

}  // namespace platon
