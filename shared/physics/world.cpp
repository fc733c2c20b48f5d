#include "platon/physics/world.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

#include "platon/physics/entity.h"
#include "shared/exact/hash.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/step/step_scratch.h"
#include "shared/physics/world_link.h"

namespace platon {
World::World() : geometry_(std::make_shared<Geometry>()), rules_(nullptr), scratch_(std::make_unique<StepScratch>()) {}

World::World(const World& other)
    : geometry_(other.geometry_),
      shapes_(other.shapes_),
      state_(other.state_),
      rules_(other.rules_),
      scratch_(std::make_unique<StepScratch>()) {}

// Keeps the derived state of this world when it is still valid, so that repeated assignment does not rebuild it.
World& World::operator=(const World& other) {
  if (this == &other) return *this;
  if (scratch_ != nullptr) requireNoCallback();
  if (geometry_ != other.geometry_ || shapes_ != other.shapes_) {
    geometry_ = other.geometry_;
    shapes_ = other.shapes_;
    scratch_ = std::make_unique<StepScratch>();
  }
  state_ = other.state_;
  rules_ = other.rules_;
  return *this;
}

void World::setRules(Rules& rules) {
  requireNoStep();
  rules_ = &rules;
}

void World::resetRules() {
  requireNoStep();
  rules_ = nullptr;
}

Rules& World::rules() const {
  if (rulesOfCall_ != nullptr) return *rulesOfCall_;
  return rules_ != nullptr ? *rules_ : scratch_->defaults;
}

void World::requireNoStep() const {
  if (!scratch_->stepping) return;
  throw std::logic_error(
      "the world cannot be changed during a step: Rules::pierce and StepObserver may only read it; change it in a "
      "callback or after solve()");
}

void World::requireNoCallback() const {
  requireNoStep();
  if (!scratch_->events.isDelivering()) return;
  throw std::logic_error(
      "a callback of Rules cannot solve, restore or assign to its world: events of the step still wait; do it after "
      "solve()");
}

// Refuses to go on when an observer or Rules::pierce has moved this world elsewhere.
void World::requireNotMoved(const StepScratch& scratch) const {
  if (scratch_.get() != &scratch) throw std::logic_error("the world was moved during its step");
}

// The step works on copies, so that the world stays as it was until all entities have moved.
void World::solve(StepObserver* observer) {
  requireNoCallback();
  if (link_) link_->requireInitialised(*geometry_);
  StepScratch* const scratch = scratch_.get();
  scratch->trimShapes();
  scratch->provideFor(state_.entities.size());
  {
    StepGuard guard(*scratch);
    moveAll(observer);
    guard.complete();
  }
  state_.entities.swap(scratch->entities);
  state_.instances.swap(scratch->further);
  deliverEvents();
}

void World::solve(Rules& rules, StepObserver* observer) {
  requireNoCallback();
  struct Guard {
    Rules*& rulesOfCall;
    ~Guard() { rulesOfCall = nullptr; }
  } const guard{rulesOfCall_ = &rules};
  solve(observer);
}

void World::moveAll(StepObserver* observer) {
  StepScratch& scratch = *scratch_;
  scratch.entities = state_.entities;
  scratch.further.clear();
  const Rules::Scope scope = rules().scope();
  const bool mayRepeat = observer == nullptr && scope != Rules::Scope::kEverything;
  std::size_t next = 0;
  for (std::uint32_t index = 0; index < state_.entities.size(); ++index) {
    const EntityState& entity = state_.entities[index];
    const std::span<const InstanceState> further(state_.instances.data() + next, entity.instances);
    next += entity.instances;
    if (entity.inserted == 0) continue;
    if (const Rest& rest = scratch.caches[index].rest; mayRepeat && rest.matches(entity, further, rules(), scope)) {
      rest.repeat(scratch.events, idOf(index), scratch.further);
    } else {
      move(index, further, observer);
    }
  }
}

void World::move(std::uint32_t index, std::span<const InstanceState> further, StepObserver* observer) {
  StepScratch& scratch = *scratch_;
  EntityState& entity = scratch.entities[index];
  EntityCache& cache = load(index, entity, further);
  const bool mayFly = observer == nullptr && cache.touched == Collider::kNoSegment;
  if (mayFly && flyFreely(entity, cache.instances, cache.regions, scratch.work)) return cache.rest.forget();
  const std::size_t firstFurther = scratch.further.size();
  const std::size_t firstEvent = scratch.events.size();
  StepState step = beginStep(index, entity, observer);
  takeStep(step, scratch.further);
  requireNotMoved(scratch);
  const Collider& collider = scratch.collider;
  if (collider.scope() == Rules::Scope::kEverything) return;
  const auto furtherAfter = std::span(scratch.further).subspan(firstFurther);
  cache.rest.record(state_.entities[index], further, entity, furtherAfter, scratch.events.since(firstEvent), collider);
}

// Loads the instances of an entity for a step. `state` and `further` may differ from its state in this world.
EntityCache& World::load(std::uint32_t index, const EntityState& state, std::span<const InstanceState> further) {
  EntityCache& cache = scratch_->caches[index];
  cache.instances.load(*geometry_, scratch_->shapes, *shapes_[state.shape], state, further);
  return cache;
}

// The step of an entity whose instances have been loaded from `state`.
StepState World::beginStep(std::uint32_t index, EntityState& state, StepObserver* observer) {
  StepScratch& scratch = *scratch_;
  EntityCache& cache = scratch.caches[index];
  Collider& collider = scratch.collider;
  collider.begin(rules(), Entity(*this, index), cache.instances, cache.regions, scratch.work);
  StepState step{.id = idOf(index),
                 .entity = state,
                 .instances = cache.instances,
                 .collider = collider,
                 .buffers = scratch.buffers,
                 .events = scratch.events,
                 .observer = observer,
                 .touched = cache.touched};
  step.observe();
  return step;
}

// A callback that causes events has them delivered after those that wait.
void World::deliverEvents() {
  StepScratch* const scratch = scratch_.get();
  if (scratch->events.isDelivering()) return;
  const StepEvents::Delivery delivery(scratch->events);
  while (const StepEvents::Event* event = scratch->events.next()) {
    if (!event->isPaired() && !exists(event->entity)) continue;
    Entity entity(*this, event->entity);
    event->deliver(rules(), entity);
    if (scratch_.get() != scratch) return;  // the callback has moved the world
  }
}

void World::restore(const WorldState& state) {
  requireNoCallback();
  if (const auto reason = fault(state)) throw std::invalid_argument("the state does not fit this world: " + *reason);
  state_ = state;
}

void World::restoreUnchecked(const WorldState& state) {
  requireNoCallback();
  assert(accepts(state));
  state_ = state;
}

std::uint64_t WorldState::hash() const {
  Hash hash;
  // The hashes of the records do not wait for each other.
  for (const EntityState& entity : entities) hash.add(hashOfRecord(entity));
  for (const InstanceState& instance : instances) hash.add(hashOfRecord(instance));
  for (const std::uint32_t generation : generations) hash.add(generation);
  return hash.value();
}

// Whether the map parts and the shapes are equal.
bool World::isBuiltLike(const World& other) const {
  const auto isSame = [](const auto& x, const auto& y) { return x == y || *x == *y; };
  return isSame(geometry_, other.geometry_) &&
         std::equal(shapes_.begin(), shapes_.end(), other.shapes_.begin(), other.shapes_.end(), isSame);
}

std::span<const InstanceState> World::instancesOf(std::uint32_t entity) const {
  const std::size_t count = state_.entities[checked(entity)].instances;
  std::size_t first = 0;
  for (std::uint32_t i = 0; i < entity; ++i) first += state_.entities[i].instances;
  return std::span(state_.instances).subspan(first, count);
}

Point World::positionOf(std::uint32_t entity, const InstanceState& instance) const {
  return platon::positionOf(state_.entities[checked(entity)], instance);
}

const Convex& World::shapeOf(std::uint32_t entity) const { return *shapes_[state_.entities[checked(entity)].shape]; }

const Convex* World::rotatedShapeOf(std::uint32_t entity, Angle angle) {
  return scratch_->shapes.turned(state_.entities[checked(entity)].shape, shapeOf(entity), angle);
}

std::vector<InstanceView> World::view(std::uint32_t entity) const {
  std::vector<InstanceView> views;
  if (state_.entities[checked(entity)].inserted == 0) return views;
  Instances instances;
  ShapeCache shapes;
  instances.load(*geometry_, shapes, shapeOf(entity), state_.entities[entity], instancesOf(entity));
  instances.appendViews(views);
  return views;
}

std::uint32_t World::addShape(const Convex& shape) {
  requireNoStep();
  const auto known = std::find_if(shapes_.begin(), shapes_.end(), [&](const auto& other) { return *other == shape; });
  const auto index = static_cast<std::uint32_t>(known - shapes_.begin());
  if (known == shapes_.end()) shapes_.push_back(std::make_shared<const Convex>(shape));
  return index;
}

}  // namespace platon
