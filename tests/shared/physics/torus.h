#pragma once

#include <cstdint>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/sim/seeded_random.h"

namespace platon {

/// Half the edge of a part of the torus.
inline constexpr std::int32_t kTorusReach = 1000;
/// The parts are two by two, in two frames.
inline constexpr std::uint32_t kTorusParts = 4;
/// Number of segments of a part, which come before its four warps.
inline constexpr std::uint32_t kTorusSegments = 12;

/// Adds part `id` of a torus, a square with random segments.
inline void addTorusPart(World& world, std::uint32_t id, sim::SeededRandom& random) {
  MapPart part(world, id);
  for (std::uint32_t i = 0; i < kTorusSegments; ++i) {
    const Point a = random.vector(kTorusReach - 20);
    part.line(a, a + random.vector(i % 2 == 0 ? 40 : 400));
  }
  const auto frameOf = [](std::uint32_t of) { return Angle(static_cast<std::int32_t>(of / 2) * Angle::kTurn / 4); };
  for (std::int32_t edge = 0; edge < 4; ++edge) {
    const Angle side(edge * Angle::kTurn / 4);
    const Point a = rotate(Point(-kTorusReach, -kTorusReach), side);
    const Point b = rotate(Point(kTorusReach, -kTorusReach), side);
    const Point back = rotate(Point(0, 2 * kTorusReach), side);
    const std::uint32_t next = id ^ (edge % 2 == 0 ? 2U : 1U);
    part.warp(rotate(a, frameOf(id)), rotate(b, frameOf(id)), next, rotate(a + back, frameOf(next)),
              rotate(b + back, frameOf(next)));
  }
  part.initialize();
}

}  // namespace platon
