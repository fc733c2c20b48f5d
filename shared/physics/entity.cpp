#include "platon/physics/entity.h"

#include <cassert>

#include "platon/physics/world.h"

namespace platon {
Entity::Entity(World& world, const intern::Convex& shape) : Entity(world, Convex(shape)) {}

Entity::Entity(World& world, const Convex& shape) : world_(&world), index_(world.add(shape)) {}

const EntityState& Entity::state() const { return world_->state_.entities[index_]; }
Point Entity::position() const { return state().position; }
Point Entity::velocity() const { return platon::rotate(state().velocity, state().heading); }
Angle Entity::rotation() const { return state().angle; }
std::uint32_t Entity::part() const { return state().part; }
bool Entity::inserted() const { return state().inserted != 0; }
const Convex& Entity::shape() const { return world_->shapeOf(index_); }

void Entity::setVelocity(Point velocity) { setVelocity(velocity, Angle()); }

void Entity::setVelocity(Point velocity, Angle frame) {
  assert(isVelocity(velocity));
  EntityState& mine = world_->state_.entities[index_];
  mine.velocity = velocity;
  mine.heading = frame;
}

void Entity::addVelocity(Point change) { setVelocity(velocity() + change); }

void Entity::rotate(std::int32_t centidegrees) {
  assert(centidegrees > -Angle::kTurn && centidegrees < Angle::kTurn);
  world_->state_.entities[index_].turn = centidegrees;
}

}  // namespace platon
