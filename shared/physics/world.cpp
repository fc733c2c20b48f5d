#include "platon/physics/world.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "platon/physics/entity.h"
#include "shared/exact/hash.h"
#include "shared/physics/step_scratch.h"
#include "shared/physics/world_link.h"

namespace platon {
namespace {

// The rules of a world on which setRules was not called.
class DefaultRules : public Rules {
 public:
  bool ignoresWarps() const override { return true; }
};

std::string named(std::uint32_t entity, std::uint32_t part) {
  return "entity " + std::to_string(entity) + " in map part " + std::to_string(part) + ": ";
}

}  // namespace

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
  if (geometry_ != other.geometry_ || shapes_ != other.shapes_) {
    geometry_ = other.geometry_;
    shapes_ = other.shapes_;
    scratch_ = std::make_unique<StepScratch>();
  }
  state_ = other.state_;
  rules_ = other.rules_;
  return *this;
}

void World::solve(StepObserver* observer) {
  DefaultRules defaults;
  solve(rules_ != nullptr ? *rules_ : defaults, observer);
}

void World::solve(Rules& rules, StepObserver* observer) {
  StepScratch& scratch = *scratch_;
  if (scratch.shapes.trim()) scratch.forgetShapes();
  scratch.further.clear();
  scratch.provideFor(state_.entities.size());
  const bool mayRepeat = observer == nullptr && rules.ignoresWarps();
  std::size_t next = 0;
  for (std::uint32_t index = 0; index < state_.entities.size(); ++index) {
    EntityState& entity = state_.entities[index];
    const std::span<const InstanceState> further(state_.instances.data() + next, entity.instances);
    next += entity.instances;
    if (entity.inserted == 0) continue;
    if (mayRepeat && scratch.rests[index].matches(entity, further)) {
      scratch.rests[index].repeat(Entity(*this, index), rules, scratch.further);
    } else {
      move(index, further, rules, observer);
    }
  }
  state_.instances.swap(scratch.further);
}

void World::move(std::uint32_t index, std::span<const InstanceState> further, Rules& rules, StepObserver* observer) {
  StepScratch& scratch = *scratch_;
  EntityState& entity = state_.entities[index];
  const EntityState before = entity;
  const std::size_t first = scratch.further.size();
  EntityStep& step = scratch.steps[index];
  beginStep(index, further, rules, observer);
  step.rotateShape(std::exchange(entity.turn, 0));
  step.translate(entity.velocity, entity.heading);
  step.finish(scratch.further);
  const auto furtherAfter = std::span(scratch.further).subspan(first);
  if (rules.ignoresWarps()) scratch.rests[index].record(before, further, entity, furtherAfter, step.contacts());
}

void World::beginStep(std::uint32_t index, std::span<const InstanceState> further, Rules& rules,
                      StepObserver* observer) {
  EntityState& entity = state_.entities[index];
  const EntityStep::Context context{
      *geometry_, *shapes_[entity.shape], scratch_->shapes, scratch_->regions[index], scratch_->work, rules, observer};
  scratch_->steps[index].begin(Entity(*this, index), entity, further, context);
}

void World::restore(const WorldState& state) {
  if (const auto reason = fault(state)) throw std::invalid_argument("the state does not fit this world: " + *reason);
  state_ = state;
}

void World::restoreUnchecked(const WorldState& state) {
  assert(accepts(state));
  state_ = state;
}

std::uint64_t WorldState::hash() const {
  Hash hash;
  const auto add = [&](const char*, const auto& field) { hash.add(field); };
  for (const EntityState& entity : entities) EntityState::visit(entity, add);
  for (const InstanceState& instance : instances) InstanceState::visit(instance, add);
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
  const auto known = std::find_if(shapes_.begin(), shapes_.end(), [&](const auto& other) { return *other == shape; });
  const auto index = static_cast<std::uint32_t>(known - shapes_.begin());
  if (known == shapes_.end()) shapes_.push_back(std::make_shared<const Convex>(shape));
  return index;
}

void World::insert(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  if (geometry_->find(part) == nullptr)
    throw std::invalid_argument(named(entity, part) + "the part is not initialised");
  if (isIn(entity, part))
    throw std::invalid_argument(named(entity, part) + "the entity is already in this part: erase it first");
  if (!shapeOf(entity).turned(angle)) {
    throw std::invalid_argument(named(entity, part) + "the shape is degenerate when rotated by this angle and rounded");
  }
  const WorldState before = state_;
  state_.entities[entity].inserted == 0 ? placeHome(entity, part, origin, angle)
                                        : placeFurther(entity, part, origin, angle);
  if (insertReachedInstances(entity)) return;
  state_ = before;
  throw std::invalid_argument(named(entity, part) + "the shape overlaps a blocking segment");
}

void World::placeHome(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  EntityState& state = state_.entities[entity];
  state.part = part;
  state.position = origin;
  state.angle = angle;
  state.remainder = Point();
  state.id = allocateId(state.nextId, [](std::uint16_t) { return false; });
  state.inserted = 1;
  state.fresh = 1;
}

void World::placeFurther(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  EntityState& state = state_.entities[entity];
  if (state.instances + 1u >= Instances::kMax) throw std::invalid_argument(named(entity, part) + "too many instances");
  InstanceState instance;
  instance.part = part;
  instance.angle = angle;
  instance.homeAnchor = state.position;
  instance.anchor = origin;
  const auto others = instancesOf(entity);
  instance.id = allocateId(state.nextId, [&](std::uint16_t id) {
    return id == state.id ||
           std::any_of(others.begin(), others.end(), [&](const InstanceState& other) { return other.id == id; });
  });
  instance.fresh = 1;
  replaceInstances(entity, [&](std::vector<InstanceState>& further) { further.push_back(instance); });
}

// Adds the instances that the shape reaches at its position. Returns false when one overlaps a blocking segment.
bool World::insertReachedInstances(std::uint32_t entity) {
  DefaultRules defaults;
  const auto known = instancesOf(entity);
  const std::vector<InstanceState> before(known.begin(), known.end());
  scratch_->provideFor(state_.entities.size());
  beginStep(entity, before, rules_ != nullptr ? *rules_ : defaults, nullptr);
  EntityStep& step = scratch_->steps[entity];
  if (!step.isFree() || !step.insertReachedInstances() || !step.isFree()) return false;
  replaceInstances(entity, [&](std::vector<InstanceState>& further) {
    further.clear();
    step.store(further);
  });
  return true;
}

template <class Edit>
void World::replaceInstances(std::uint32_t entity, Edit&& edit) {
  const auto first = state_.instances.begin() + (instancesOf(entity).data() - state_.instances.data());
  const auto last = first + state_.entities[entity].instances;
  std::vector<InstanceState> further(first, last);
  const auto gap = state_.instances.erase(first, last);
  edit(further);
  state_.instances.insert(gap, further.begin(), further.end());
  state_.entities[entity].instances = static_cast<std::uint16_t>(further.size());
}

bool World::isIn(std::uint32_t entity, std::uint32_t part) const {
  const EntityState& state = state_.entities[checked(entity)];
  const auto further = instancesOf(entity);
  return state.inserted != 0 &&
         (state.part == part || std::any_of(further.begin(), further.end(),
                                            [&](const InstanceState& instance) { return instance.part == part; }));
}

// Also removes all instances with a parent; the next step adds those again that are still needed.
void World::erase(std::uint32_t entity, std::uint32_t part) {
  if (!isIn(entity, part)) return;
  EntityState& state = state_.entities[entity];
  replaceInstances(entity, [&](std::vector<InstanceState>& further) {
    std::erase_if(further, [&](const InstanceState& instance) {
      return instance.part == part || instance.parent != InstanceState::kNoParent;
    });
    if (state.part == part) promoteFirst(state, further);
  });
}

// Makes the first further instance the home instance and anchors the others to it at their current positions.
void World::promoteFirst(EntityState& state, std::vector<InstanceState>& further) {
  state.inserted = further.empty() ? 0 : 1;
  if (further.empty()) return;
  for (InstanceState& instance : further) {
    instance.anchor = platon::positionOf(state, instance);
    instance.homeAnchor = further.front().anchor;
  }
  const InstanceState nextHome = further.front();
  state.part = nextHome.part;
  state.position = nextHome.anchor;
  state.remainder = Point();
  state.heading = state.heading + (nextHome.angle - state.angle);
  state.angle = nextHome.angle;
  state.id = nextHome.id;
  state.fresh = nextHome.fresh;
  further.erase(further.begin());
}

void World::remove(std::uint32_t entity) {
  replaceInstances(entity, [](std::vector<InstanceState>& further) { further.clear(); });
  state_.entities[entity].inserted = 0;
}

}  // namespace platon
