#pragma once

#include <cstdint>
#include <vector>

#include "shared/physics/entity.h"
#include "shared/physics/map_part.h"
#include "shared/physics/world.h"

namespace platon {

/// Adds a part of these lines to the world.
inline void addPart(World& world, std::uint32_t id, const std::vector<Segment>& lines) {
  MapPart part(world, id);
  for (const Segment& line : lines) part.line(line.a, line.b);
  part.initialize();
}

/// Two parts side by side: each is a strip 2000 wide round its own origin, and the right edge of part 1 is the left
/// edge of part 2.
inline World twoStrips(const std::vector<Segment>& first = {}, const std::vector<Segment>& second = {}) {
  World world;
  MapPart left(world, 1);
  for (const Segment& line : first) left.line(line.a, line.b);
  left.warp({1000, -5000}, {1000, 5000}, 2, {-1000, -5000}, {-1000, 5000});
  left.initialize();
  MapPart right(world, 2);
  for (const Segment& line : second) right.line(line.a, line.b);
  right.warp({-1000, 5000}, {-1000, -5000}, 1, {1000, 5000}, {1000, -5000});
  right.initialize();
  return world;
}

}  // namespace platon
