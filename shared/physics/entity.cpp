#include "platon/physics/entity.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/physics/world.h"
#include "shared/physics/world_link.h"

namespace platon {
namespace {

[[noreturn]] void refuse(std::uint32_t entity, const char* reason) {
  throw std::invalid_argument("entity " + std::to_string(entity) + ": " + reason);
}

void requireVelocity(bool holds, std::uint32_t entity) {
  if (!holds) refuse(entity, "the velocity is out of range: its coordinates must be below 2^28 in magnitude");
}

}  // namespace

Entity::Entity(World& world, const intern::Convex& shape) : Entity(world, Convex(shape)) {}

Entity::Entity(World& world, const Convex& shape) : Entity(world, world.add(shape)) {}

Entity::Entity(World& world, std::uint32_t index) : Entity(world, {index, world.state().generationOf(index)}) {}

Entity::Entity(World& world, EntityId id) : link_(&world.link()), id_(id) {}

World& Entity::world() const { return link_->target(); }
bool Entity::exists() const { return link_->world != nullptr && link_->world->exists(id_); }
void Entity::erase() { world().erase(world().checked(id_)); }
void Entity::destroy() { world().destroy(world().checked(id_)); }

const EntityState& Entity::state() const {
  const World& mine = world();
  return mine.state_.entities[mine.checked(id_)];
}

EntityState& Entity::mutableState() {
  World& mine = world();
  mine.requireNoStep();
  return mine.state_.entities[mine.checked(id_)];
}

Point Entity::position() const { return state().position; }
Point Entity::velocity() const { return platon::rotate(state().velocity, state().heading); }
Angle Entity::rotation() const { return state().angle; }
std::uint32_t Entity::part() const { return state().part; }
Angle Entity::heading() const { return state().heading; }
bool Entity::inserted() const { return state().inserted != 0; }

bool Entity::isAtLimit() const {
  constexpr std::int32_t kNear = 8;
  const EntityState& mine = state();
  const auto isNear = [](Point position) { return maxNorm(position) >= kCoordinateLimit - kNear; };
  if (mine.inserted == 0) return false;
  const auto further = world().instancesOf(id_.index);
  return isNear(mine.position) || std::any_of(further.begin(), further.end(), [&](const InstanceState& instance) {
           return isNear(positionOf(mine, instance));
         });
}

const Convex& Entity::shape() const { return world().shapeOf(world().checked(id_)); }

void Entity::setVelocity(Point velocity) { setVelocity(velocity, Angle()); }

void Entity::setVelocity(Point velocity, Angle frame) {
  requireVelocity(isVelocity(velocity), id_.index);
  EntityState& mine = mutableState();
  mine.velocity = velocity;
  mine.heading = frame;
}

void Entity::addVelocity(Point change) { addVelocity(change, Angle()); }

void Entity::addVelocity(Point change, Angle frame) {
  requireVelocity(isCoordinate(change.x) && isCoordinate(change.y), id_.index);  // so that the sum fits 32 bits
  EntityState& mine = mutableState();
  const Point sum = mine.velocity + platon::rotate(change, frame - mine.heading);
  requireVelocity(isVelocity(sum), id_.index);
  mine.velocity = sum;
}

void Entity::rotate(std::int32_t centidegrees) {
  if (centidegrees <= -Angle::kTurn || centidegrees >= Angle::kTurn)
    refuse(id_.index, "the rotation is out of range: it must be below 36000 centidegrees in magnitude");
  mutableState().turn = centidegrees;
}

}  // namespace platon
