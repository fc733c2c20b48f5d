#pragma once

#include <vector>

#include "platon/exact/angle.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/shared/physics/maps.h"

namespace platon {

/// A world with one part and one entity in it.
struct Scene {
  Scene(const std::vector<Segment>& lines, const Convex& shape, Point at) : entity(make(lines, shape, at)) {}

  Entity make(const std::vector<Segment>& lines, const Convex& shape, Point at) {
    addPart(world, 0, lines);
    Entity made(world, shape);
    MapPart(world, 0).insert(made, at, Angle());
    return made;
  }
  Point step(Point velocity) {
    entity.setVelocity(velocity);
    world.solve();
    return entity.position();
  }

  World world;
  Entity entity;
};

}  // namespace platon
