#pragma once

#include <cstdint>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"

namespace platon {

/// Adds a part with these segments to the world.
inline void addPart(World& world, std::uint32_t id, const std::vector<Segment>& lines) {
  MapPart part(world, id);
  for (const Segment& line : lines) part.line(line.a, line.b);
  part.initialize();
}

/// Adds part 1, a strip of width 2000 centred on its origin. Its right edge is the left edge of part 2.
inline void addLeftStrip(World& world, const std::vector<Segment>& lines = {}) {
  MapPart part(world, 1);
  for (const Segment& line : lines) part.line(line.a, line.b);
  part.warp({1000, -5000}, {1000, 5000}, 2, {-1000, -5000}, {-1000, 5000});
  part.initialize();
}

/// Adds part 2, a strip of the same width. Its left edge is the right edge of part 1.
inline void addRightStrip(World& world, const std::vector<Segment>& lines = {}) {
  MapPart part(world, 2);
  for (const Segment& line : lines) part.line(line.a, line.b);
  part.warp({-1000, 5000}, {-1000, -5000}, 1, {1000, 5000}, {1000, -5000});
  part.initialize();
}

/// A world of both strips.
inline World twoStrips(const std::vector<Segment>& first = {}, const std::vector<Segment>& second = {}) {
  World world;
  addLeftStrip(world, first);
  addRightStrip(world, second);
  return world;
}

}  // namespace platon
