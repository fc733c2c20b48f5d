// Insertion and removal of entities, outside of steps.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/step/stages.h"
#include "shared/physics/step/step_scratch.h"

namespace platon {
namespace {

std::string named(std::uint32_t entity, std::uint32_t part) {
  return "entity " + std::to_string(entity) + " in map part " + std::to_string(part) + ": ";
}

void requireInitialised(const Geometry& geometry, std::uint32_t part) {
  if (geometry.find(part) != nullptr) return;
  throw std::invalid_argument("map part " + std::to_string(part) +
                              " is not initialised: call MapPart::initialize before canPlace()");
}

}  // namespace

// An entity and its further instances, outside of the state of the world.
struct World::Placed {
  EntityState state;
  std::vector<InstanceState> further;
};

World::Placed World::placedOf(std::uint32_t entity) const {
  const auto further = instancesOf(entity);
  return {state_.entities[entity], {further.begin(), further.end()}};
}

void World::insert(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  requireNoStep();
  if (geometry_->find(part) == nullptr)
    throw std::invalid_argument(named(entity, part) + "the part is not initialised");
  if (isIn(entity, part))
    throw std::invalid_argument(named(entity, part) + "the entity is already in this part: erase it first");
  Placed placed = placedOf(entity);
  if (const char* const fault = insertInto(placed, entity, part, origin, angle))
    throw std::invalid_argument(named(entity, part) + fault);
  replace(entity, placed);
}

bool World::canPlace(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  requireNoStep();
  requireInitialised(*geometry_, part);
  if (!isCoordinate(origin.x) || !isCoordinate(origin.y)) return false;
  Placed placed = placedOf(entity);
  if (isIn(entity, part)) eraseFrom(placed, part);
  return insertInto(placed, entity, part, origin, angle) == nullptr;
}

bool World::canPlace(std::uint32_t part, const Convex& shape, Point origin, Angle angle, Rules& rules) const {
  requireInitialised(*geometry_, part);
  World trial(*this);
  trial.rules_ = &rules;
  return trial.canPlace(trial.add(shape), part, origin, angle);
}

// Adds an instance of the entity and those that its shape reaches. Returns what is wrong with the place, or null.
const char* World::insertInto(Placed& placed, std::uint32_t entity, std::uint32_t part, Point origin, Angle angle) {
  if (!shapeOf(entity).turned(angle)) return "the shape is degenerate when rotated by this angle and rounded";
  if (placed.further.size() + 1 >= Instances::kMax) return "too many instances";
  const std::uint16_t inserted = place(placed, part, origin, angle);
  return insertReached(entity, placed, inserted) ? nullptr : "the shape overlaps a blocking segment";
}

// Adds an instance, as the home instance when there is none, and returns its id.
std::uint16_t World::place(Placed& placed, std::uint32_t part, Point origin, Angle angle) const {
  EntityState& state = placed.state;
  if (state.inserted == 0) {
    state.part = part;
    state.position = origin;
    state.angle = angle;
    state.remainder = Point();
    state.id = allocateId(state.nextId, [](std::uint16_t) { return false; });
    state.inserted = 1;
    state.fresh = 1;
    return state.id;
  }
  InstanceState instance;
  instance.part = part;
  instance.angle = angle;
  instance.homeAnchor = state.position;
  instance.anchor = origin;
  instance.id = allocateId(state.nextId, [&](std::uint16_t id) {
    return id == state.id || std::any_of(placed.further.begin(), placed.further.end(),
                                         [&](const InstanceState& other) { return other.id == id; });
  });
  instance.fresh = 1;
  placed.further.push_back(instance);
  return instance.id;
}

// Adds the instances that the shape reaches at its position. Returns false when one overlaps a blocking segment. What
// the instances other than `inserted` overlap does not block.
bool World::insertReached(std::uint32_t entity, Placed& placed, std::uint16_t inserted) {
  scratch_->provideFor(state_.entities.size());
  StepScratch& scratch = *scratch_;
  const StepGuard guard(scratch);
  load(entity, placed.state, placed.further);
  StepState step = beginStep(entity, placed.state, nullptr);
  pierceOverlapped(step, inserted);
  const auto isFree = [&] { return step.isFree(step.position(), step.position()); };
  if (!isFree() || !insertReachedInstances(step) || !isFree()) return false;
  requireNotMoved(scratch);
  placed.further.clear();
  step.store(placed.further);
  return true;
}

// Replaces the state of an entity and its further instances, and tells the rules.
void World::replace(std::uint32_t entity, const Placed& placed) {
  replaceSilently(entity, placed);
  deliverEvents();
}

// As above, without the callbacks. Contacts begin and end by what the instances overlap: their events wait.
void World::replaceSilently(std::uint32_t entity, const Placed& placed) {
  StepScratch& scratch = *scratch_;
  StepEvents& events = scratch.events;
  if (rules().scope() != Rules::Scope::kContacts) {
    scratch_->provideFor(state_.entities.size());
    const auto before = contactsOf(entity, placedOf(entity));
    const auto after = contactsOf(entity, placed);
    requireNotMoved(scratch);
    const auto addMissing = [&](StepEvents::Kind kind, const auto& refs, const auto& others) {
      for (const SegmentRef& ref : refs) {
        if (!Collider::contains(others, ref)) events.add(kind, idOf(entity)).segment = ref;
      }
    };
    addMissing(StepEvents::Kind::kEnd, before, after);
    addMissing(StepEvents::Kind::kBegin, after, before);
  }
  const auto known = instancesOf(entity);
  const auto at = state_.instances.begin() + (known.data() - state_.instances.data());
  const auto gap = state_.instances.erase(at, at + static_cast<std::ptrdiff_t>(known.size()));
  state_.instances.insert(gap, placed.further.begin(), placed.further.end());
  state_.entities[entity] = placed.state;
  state_.entities[entity].instances = static_cast<std::uint16_t>(placed.further.size());
}

// The contacts of an entity in this state that have begun.
std::vector<SegmentRef> World::contactsOf(std::uint32_t entity, Placed placed) {
  std::vector<SegmentRef> contacts;
  if (placed.state.inserted == 0) return contacts;
  load(entity, placed.state, placed.further);
  StepState step = beginStep(entity, placed.state, nullptr);
  pierceOverlapped(step);
  appendContacts(step, contacts);
  return contacts;
}

bool World::isIn(std::uint32_t entity, std::uint32_t part) const {
  const EntityState& state = state_.entities[checked(entity)];
  const auto further = instancesOf(entity);
  return state.inserted != 0 &&
         (state.part == part || std::any_of(further.begin(), further.end(),
                                            [&](const InstanceState& instance) { return instance.part == part; }));
}

void World::erase(std::uint32_t entity, std::uint32_t part) {
  requireNoStep();
  if (!isIn(entity, part)) return;
  Placed placed = placedOf(entity);
  eraseFrom(placed, part);
  replace(entity, placed);
}

// Also removes all instances with a parent; the next step adds those again that are still needed.
void World::eraseFrom(Placed& placed, std::uint32_t part) {
  std::erase_if(placed.further, [&](const InstanceState& instance) {
    return instance.part == part || instance.parent != InstanceState::kNoParent;
  });
  if (placed.state.part == part) promoteFirst(placed);
}

// Makes the first further instance the home instance and anchors the others to it at their current positions.
void World::promoteFirst(Placed& placed) {
  EntityState& state = placed.state;
  state.inserted = placed.further.empty() ? 0 : 1;
  if (placed.further.empty()) return;
  for (InstanceState& instance : placed.further) {
    instance.anchor = platon::positionOf(state, instance);
    instance.homeAnchor = placed.further.front().anchor;
  }
  const InstanceState nextHome = placed.further.front();
  state.part = nextHome.part;
  state.position = nextHome.anchor;
  state.remainder = Point();
  state.heading = state.heading + (nextHome.angle - state.angle);
  state.angle = nextHome.angle;
  state.id = nextHome.id;
  state.fresh = nextHome.fresh;
  placed.further.erase(placed.further.begin());
}

void World::erase(std::uint32_t entity) {
  requireNoStep();
  Placed placed = placedOf(checked(entity));
  placed.state.inserted = 0;
  placed.further.clear();
  replace(entity, placed);
}

// The callbacks find the entity destroyed, so that they cannot place it again.
void World::destroy(std::uint32_t entity) {
  requireNoStep();
  replaceSilently(checked(entity), Placed{});
  if (state_.generations.size() <= entity) state_.generations.resize(entity + 1);
  ++state_.generations[entity];
  deliverEvents();
}

}  // namespace platon
