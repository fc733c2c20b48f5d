#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"

namespace platon {

class World;

/// A convex shape with position, velocity and rotation. The object is a handle: all state lives in the world, so that
/// a world can be copied, saved and restored as a value. It must not outlive the world.
class Entity {
 public:
  /// Adds an entity to the world. Throws std::invalid_argument when the draft is not strictly convex and
  /// counter-clockwise.
  Entity(World& world, const intern::Convex& shape);
  Entity(World& world, const Convex& shape);
  /// The entity that the world already has under this index.
  Entity(World& world, std::uint32_t index) : world_(&world), index_(index) {}

  /// In the frame of the home part, subunits.
  Point position() const;
  /// Subunits a tick in the frame of the home part.
  Point velocity() const;
  /// Of the shape in the frame of the home part.
  Angle rotation() const;
  /// Id of the map part that the entity's centre is on.
  std::uint32_t part() const;
  bool inserted() const;

  /// |velocity| < 2^28 a coordinate.
  void setVelocity(Point velocity);
  /// `velocity` in a frame that is turned by `frame` from the home part's: it is carried over edges and never rounded.
  void setVelocity(Point velocity, Angle frame);
  void addVelocity(Point change);
  /// Turns the shape at the next step by this many centidegrees (positive counter-clockwise, less than a
  /// whole turn), as far as it is free to turn.
  void rotate(std::int32_t centidegrees);

  /// Without turning: the shape it was made of.
  const Convex& shape() const;
  std::uint32_t index() const { return index_; }
  World& world() const { return *world_; }
  const EntityState& state() const;

 private:
  World* world_;
  std::uint32_t index_;
};

}  // namespace platon
