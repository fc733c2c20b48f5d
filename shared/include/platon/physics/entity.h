#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"

namespace platon {

class World;
struct WorldLink;

/// A handle to a moving convex shape. All state is stored in the world, so that worlds can be copied, saved and
/// restored. The handle follows its world when that is moved, stays with it when that is copied, and must not be used
/// after its end. Units: subunits, subunits per tick, centidegrees.
///
/// A handle names an entity by its id. Every function but id, index, exists and world throws std::invalid_argument, and
/// changes nothing, when the world has no entity with this id, or when an argument is out of its range. World::restore
/// also restores the ids: a handle that was made after the state was saved is refused, until the world makes an entity
/// with the same id again, and then names that one. So a program that rolls back saves the ids that it holds together
/// with the state.
class Entity {
 public:
  /// Adds an entity to the world. It is in no map part until MapPart::insert. It stays in the world when the handle
  /// goes away: only `destroy` ends it. Keep the handle or its id; where neither is wanted, write (void)Entity(world,
  /// shape).
  [[nodiscard]] Entity(World& world, const Convex& shape);
  /// The same with the shape that these vertices form. Throws std::invalid_argument when they are not strictly convex
  /// and counter-clockwise.
  [[nodiscard]] Entity(World& world, const intern::Convex& shape);
  /// A handle to the existing entity `index`.
  Entity(World& world, std::uint32_t index);
  /// A handle to the entity with this id.
  Entity(World& world, EntityId id);

  EntityId id() const { return id_; }
  std::uint32_t index() const { return id_.index; }
  /// The world of this handle. Throws std::invalid_argument when another world was moved onto it.
  World& world() const;
  /// Whether the entity exists, so that the handle can be used.
  bool exists() const;
  /// Erases the entity from all map parts; see World::erase.
  void erase();
  /// Destroys the entity; see World::destroy.
  void destroy();

  /// Position of the home instance in the frame of the home part.
  Point position() const;
  /// Velocity in the frame of the home part, rounded to whole subunits per tick.
  Point velocity() const;
  /// Rotation of the shape in the frame of the home part: shape().turned(rotation()) is the shape there, never empty
  /// while the entity is in a map part.
  Angle rotation() const;
  /// Id of the home part: the map part that contains the centre of the shape.
  std::uint32_t part() const;
  /// Rotation from the frame in which the velocity is stored to the frame of the home part: the `frame` passed to
  /// setVelocity, plus the turns of all edges crossed since. Not the rotation of the shape.
  Angle heading() const;
  /// Whether the entity is in a map part.
  bool inserted() const;

  /// Whether an instance is at the limit of the coordinates, at most 8 subunits from it. There a step stops the entity
  /// as a wall would, but no callback tells: a program that lets bodies fall out of its map asks after each step, and
  /// erases or returns them. A body can slide along the limit.
  bool isAtLimit() const;

  /// Sets the velocity in the frame of the home part. Requires |velocity| < 2^28 per coordinate.
  void setVelocity(Point velocity);
  /// Sets the velocity in a frame rotated by `frame` against the home part. Both values are stored unrounded, and
  /// `frame` is updated when the home part changes.
  void setVelocity(Point velocity, Angle frame);
  /// Adds `change`, given in the frame of the home part, to the velocity. The same as addVelocity(change, Angle()).
  void addVelocity(Point change);
  /// Adds `change`, given in a frame rotated by `frame` against the home part, to the velocity. The stored velocity and
  /// heading() are kept: only `change` is rotated into the frame of the stored velocity, and rounded once, to the
  /// nearest lattice point. So n additions are off by at most n / 2 along each axis of that frame (plus
  /// n * |change| * 2^-28, the error of the rotation), and by nothing where `frame` - heading() is a multiple of 90°:
  /// pass heading() to add the same change in every tick. Adding zero changes nothing; adding a change and then its
  /// negative restores the state. Requires |change| < 2^29 and a sum below 2^28 per coordinate, in the frame of the
  /// stored velocity.
  void addVelocity(Point change, Angle frame);
  /// Rotates the shape by `centidegrees` at the start of the next step, or as far as no segment blocks it. Positive is
  /// counter-clockwise; less than a whole turn in magnitude. Lasts for one step. Replaces an earlier request of the
  /// same tick.
  void rotate(std::int32_t centidegrees);

  /// The shape as it was passed to the constructor, unrotated.
  const Convex& shape() const;
  const EntityState& state() const;

 private:
  EntityState& mutableState();

  WorldLink* link_;
  EntityId id_;
};

}  // namespace platon
