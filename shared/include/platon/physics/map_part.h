#pragma once

#include <cstdint>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"

namespace platon {

class Convex;
class Entity;
class World;
struct WorldLink;

/// Builder and handle of one map part. Add segments and warps, then call `initialize` once: the geometry is
/// preprocessed, becomes immutable and is added to the world. World::solve refuses to go on while a part has segments
/// or warps and `initialize` was not called. Like an Entity, it follows its world when that is moved and must not be
/// used after its end.
class MapPart {
 public:
  /// `id` must be unique in the world by the time of `initialize`.
  MapPart(World& world, std::uint32_t id);

  /// Adds a segment and returns its index, by which callbacks and queries name it (SegmentRef::index): 0, 1, 2, … in
  /// the order of the calls. They also get `tag` (SegmentRef::tag), which is for the program: a kind of wall, or the
  /// number of a door. Two equal ends make a point, which blocks too. Segments may cross and repeat. Throws
  /// std::invalid_argument when a coordinate is not below 2^29 in magnitude or the part is initialised.
  std::uint32_t line(Point p0, Point p1, std::uint32_t tag = 0);

  /// Adds a warp from segment p0 p1 to part `targetMap`, in which the same two points are t0 and t1. This part is on
  /// the left of p0 -> p1. Entities can pass only when the target has the reverse warp, from t1 t0 to p1 p0 of this
  /// part; without it, the warp blocks like a wall, which World::mapFault tells. Throws std::invalid_argument unless
  /// both segments have the same length and differ by a whole number of centidegrees, up to 2 subunits at the ends, or
  /// when the part is initialised.
  void warp(Point p0, Point p1, std::uint32_t targetMap, Point t0, Point t1);

  /// As above, with exact midpoints: instances are placed relative to them, so the rounding of the ends does not
  /// accumulate over chains of warps. Throws std::invalid_argument when one is more than 1 subunit from the midpoint of
  /// the rounded ends.
  void warp(Segment from, std::uint32_t targetMap, Segment onto, PrecisePoint fromMiddle, PrecisePoint ontoMiddle);

  /// Builds the grid and adds the part to the world; call it once. Throws std::invalid_argument, and does not change
  /// the world, when a part with the same id exists or a warp is on the right of another one. Warps are edges of a
  /// convex area on their left, which need not be closed: the home part changes when the centre of a shape is on the
  /// right of a warp, wherever along its line. Rounded ends may be up to 2 subunits on the right.
  void initialize();

  /// Places an instance of the entity in this part, at position `origin` and rotated by `angle`. The first instance of
  /// an entity is its home instance; instances in other parts move with it. Throws std::invalid_argument when the part
  /// is not initialised, the entity does not exist, belongs to another world or is already in the part, the coordinates
  /// are out of range, or a segment overlaps the shape that blocks by the rules of World::setRules. Changes nothing
  /// then. An exception of a callback passes on; the insertion is complete. To move an entity to another place,
  /// erase it first; its velocity stays.
  void insert(Entity& entity, const Point& origin, Angle angle);

  /// Whether `insert` would place the entity there, if it was erased from this part first. False when a blocking
  /// segment overlaps the shape, when the shape is degenerate at this angle, when the coordinates are out of range or
  /// when the entity has too many instances. Asks the rules, changes nothing and calls no callback. Uses caches of the
  /// world: it is for the thread that uses the world, unlike the queries. Throws std::invalid_argument when the part is
  /// not initialised, or the entity does not exist or belongs to another world; std::logic_error when Rules::pierce or
  /// a StepObserver calls it.
  [[nodiscard]] bool canPlace(const Entity& entity, Point origin, Angle angle) const;
  /// The same for a new entity of this shape: see World::canPlace.
  [[nodiscard]] bool canPlace(const Convex& shape, Point origin, Angle angle) const;

  /// Removes the entity's instances from this part; their contacts end (see Rules). No effect when there are none.
  /// Throws std::invalid_argument when the entity does not exist or belongs to another world.
  void erase(Entity& entity);

  std::uint32_t id() const { return id_; }

 private:
  void requireOpen() const;
  World& worldOf(const Entity& entity) const;

  WorldLink* link_;
  std::uint32_t id_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> tags_;  // see MapGeometry::tags
  std::vector<Warp> warps_;
};

}  // namespace platon
