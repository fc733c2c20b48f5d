#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/exactness/oracle/trace/random_scene.h"
#include "tests/exactness/properties/lattice_map.h"
#include "tests/exactness/step_check/conversions.h"

namespace platon::properties {

/// Entities of one shape among segments on an infinite plane, part 0.
struct PlaneScene {
  std::vector<Point> shape;
  std::vector<Segment> lines;
  std::vector<Point> entities;
  std::int64_t scale = 0;  ///< about the size of the shape

  static PlaneScene from(const oracle::Scene& scene) {
    PlaneScene made{step_check::toPoints(scene.shape), {}, step_check::toPoints(scene.entities), scene.scale};
    for (const oracle::Segment& line : scene.lines) made.lines.push_back(step_check::toSegment(line));
    return made;
  }
  PlaneScene mapped(const LatticeMap& map) const {
    PlaneScene made{map.shape(shape), {}, {}, scale};
    for (const Segment& line : lines) made.lines.push_back(map.segment(line));
    for (const Point place : entities) made.entities.push_back(map.place(place));
    return made;
  }
  /// Throws std::invalid_argument if an entity overlaps a segment.
  World world() const {
    World world;
    MapPart part(world, 0);
    for (const Segment& line : lines) part.line(line.a, line.b);
    part.initialize();
    const Convex convex(shape);
    for (const Point place : entities) {
      Entity entity(world, convex);
      part.insert(entity, place, Angle());
    }
    return world;
  }
};

}  // namespace platon::properties
