// What handles rely on: worlds that move, and entities that are made and destroyed.
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "shared/physics/step/step_scratch.h"
#include "shared/physics/world_link.h"

namespace platon {
namespace {

// An index with the last generation is never used again.
bool isFree(std::uint32_t generation) {
  return WorldState::isDestroyed(generation) && generation != std::numeric_limits<std::uint32_t>::max();
}

}  // namespace

World::World(World&& other) noexcept
    : geometry_(std::move(other.geometry_)),
      shapes_(std::move(other.shapes_)),
      state_(std::move(other.state_)),
      rules_(other.rules_),
      scratch_(std::move(other.scratch_)),
      link_(std::move(other.link_)) {
  if (link_) link_->world = this;
}

// NOLINTNEXTLINE(performance-noexcept-move-constructor): a callback that assigns to its world is refused.
World& World::operator=(World&& other) {
  if (this == &other) return *this;
  if (scratch_ != nullptr) requireNoCallback();
  geometry_ = std::move(other.geometry_);
  shapes_ = std::move(other.shapes_);
  state_ = std::move(other.state_);
  rules_ = other.rules_;
  scratch_ = std::move(other.scratch_);
  if (!other.link_) return *this;  // the handles of this world find what has replaced their entities
  if (link_) other.link_->retire(std::move(link_));
  link_ = std::move(other.link_);
  link_->world = this;
  return *this;
}

World::~World() = default;

WorldLink& World::link() {
  if (!link_) link_ = std::make_unique<WorldLink>(*this);
  return *link_;
}

void WorldLink::refuse() {
  throw std::invalid_argument("another world was moved onto the world of this handle: make the handle again");
}

void WorldLink::refuseBegun(std::uint32_t part) {
  throw std::logic_error("map part " + std::to_string(part) +
                         " has segments or warps but was not initialised, so nothing meets them: call "
                         "MapPart::initialize() before solve()");
}

std::uint32_t World::add(const Convex& shape) {
  EntityState entity;
  entity.shape = addShape(shape);
  const auto free = std::find_if(state_.generations.begin(), state_.generations.end(), isFree);
  if (free == state_.generations.end()) {
    state_.entities.push_back(entity);
    return static_cast<std::uint32_t>(state_.entities.size() - 1);
  }
  ++*free;
  const auto index = static_cast<std::uint32_t>(free - state_.generations.begin());
  state_.entities[index] = entity;
  return index;
}

void World::refuse(std::uint32_t entity) const {
  const std::string name = "entity " + std::to_string(entity) + " does not exist: ";
  if (entity < state_.entities.size()) throw std::invalid_argument(name + "it was destroyed");
  throw std::invalid_argument(name + "the world has " + std::to_string(state_.entities.size()) +
                              " entities, counted from 0");
}

void World::refuse(EntityId id) const {
  checked(id.index);
  throw std::invalid_argument("entity " + std::to_string(id.index) + ": the handle is stale: it has generation " +
                              std::to_string(id.generation) + ", the entity has generation " +
                              std::to_string(state_.generationOf(id.index)));
}

}  // namespace platon
