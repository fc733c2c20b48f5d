#pragma once

#include <cstdint>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"

namespace platon {

class Entity;
class World;

/// A map partition: lines and warps are added one after another, then `initialize` hands them, preprocessed and from
/// now on immutable, to the world. The object itself is only a handle and must not outlive the world.
class MapPart {
 public:
  /// `id` is unique in the world.
  MapPart(World& world, std::uint32_t id) : world_(&world), id_(id) {}

  /// Adds a line between two points below 2^29; both equal make a point. Lines may cross and repeat.
  /// Throws std::invalid_argument on a coordinate out of range.
  void line(Point p0, Point p1);

  /// Adds a line that leads to part `targetMap`, where the same two points are t0 and t1. This part lies on the left
  /// of p0 -> p1. The turn between the two is a whole number of centidegrees, to within 2 subunits at the
  /// ends; throws std::invalid_argument otherwise. The target needs a warp back before an entity comes near.
  void warp(Point p0, Point p1, std::uint32_t targetMap, Point t0, Point t1);

  /// As above, with the true middles of the line and its image, which lie within 1 subunit of those of the rounded
  /// ends: instances are then placed by them, so that chains of warps add up no roundings.
  void warp(Segment from, std::uint32_t targetMap, Segment onto, PrecisePoint fromMiddle, PrecisePoint ontoMiddle);

  /// Builds the grid and adds the part to the world. Throws std::invalid_argument when the id is taken.
  void initialize();

  /// Places an instance of the entity here, with its position at `origin` and turned by `angle`. The first instance is
  /// the entity's home; a further one in another part moves with it from now on. Throws std::invalid_argument when the
  /// part is not initialised, when the entity is in it already, or when a blocking line overlaps the shape there.
  void insert(Entity& character, const Point& origin, Angle angle);

  /// Takes the entity's instances out of this part. Without effect when it has none here.
  void erase(Entity& character);

  std::uint32_t id() const { return id_; }

 private:
  World* world_;
  std::uint32_t id_;
  std::vector<Segment> lines_;
  std::vector<Warp> warps_;
};

}  // namespace platon
