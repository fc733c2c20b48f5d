#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/rules.h"
#include "platon/physics/step_observer.h"

namespace platon {

struct EntityCache;
class StepScratch;
struct StepState;
struct WorldLink;

/// The saved state of a world. Together with the geometry, the shapes and the rules it determines all later states.
struct WorldState {
  std::vector<EntityState> entities;
  std::vector<InstanceState> instances;  ///< further instances of all entities, in order of the entities
  /// By index of the entity: twice the number of earlier entities with this index, plus 1 while it is free. Indices
  /// behind the end have generation 0, and the last element is not 0: a world in which no entity was destroyed has
  /// none.
  std::vector<std::uint32_t> generations = {};

  /// The generation of this index.
  std::uint32_t generationOf(std::uint32_t entity) const {
    return entity < generations.size() ? generations[entity] : 0;
  }
  /// Whether an index of this generation is free.
  static constexpr bool isDestroyed(std::uint32_t generation) { return generation % 2 != 0; }

  friend bool operator==(const WorldState&, const WorldState&) = default;

  /// Hash of all fields, identical on every platform.
  std::uint64_t hash() const;
};

/// A collection of map parts and of the entities that move on them. Has value semantics: a copy has its own state and
/// shares the immutable geometry. Deterministic: equal states and equal calls give identical states on every platform.
///
/// Handles (Entity, MapPart) belong to one world and must not be used after its end:
///  - A copy has no handles of its own, and copy assignment leaves those of both worlds where they are.
///  - Handles follow a world that is moved. Those of a world onto which another is moved are refused, or, if the other
///    never had a handle, name what is in their place now.
///
/// Functions that take the index of an entity throw std::invalid_argument when the world has no such entity. A world
/// that was moved from may only be assigned to or destroyed.
///
/// Functions that change the world throw std::logic_error when Rules::pierce or a StepObserver calls them: the world
/// may be read during a step, and is then as it was before. Callbacks of Rules may change it, except by solving it,
/// restoring it or assigning to it, by copy or by move: these also throw std::logic_error and change nothing. A world
/// that a callback moves elsewhere, as std::swap does, is not refused: the events that wait are dropped.
class World {
 public:
  World();
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&);  // not noexcept: a callback that assigns to its world is refused
  ~World();

  /// Sets the rules for all that follows: `solve` and MapPart::insert ask them which segments block, and they receive
  /// the events. They must exist until other rules are set or the world is last used. Copies of the world have the same
  /// rules and call the same callbacks: see solve(Rules&).
  void setRules(Rules& rules);
  /// Sets the default rules: segments block, warps can be passed, and events have no effect.
  void resetRules();

  /// Advances all entities by one tick, in order of their indices, then delivers the events to the rules (see Rules).
  /// Reports every leg to `observer` unless it is null. When Rules::pierce or `observer` throws, the world stays as it
  /// was. When a callback throws, the step is complete. Throws std::logic_error, and changes nothing, when a callback,
  /// `pierce` or an observer calls it, or when a map part has segments or warps but MapPart::initialize was not called.
  void solve(StepObserver* observer = nullptr);
  /// The same by `rules` instead of those of setRules: they are asked in this tick and receive its events, also those
  /// of changes that its callbacks make. Rules that a callback sets are those of later calls. So a copy that predicts
  /// can be solved without the callbacks of the original. Throws as solve() does.
  void solve(Rules& rules, StepObserver* observer = nullptr);

  /// A copy of the current state, for `restore`.
  [[nodiscard]] WorldState save() const { return state_; }
  /// The state itself. The reference follows the world: what it shows changes with it, and all that it refers to is
  /// valid only until the world changes. `kept = world.state()` saves into memory that `kept` has already.
  const WorldState& state() const { return state_; }
  /// Replaces the state. Throws std::invalid_argument with the text of fault() when this world does not accept it, and
  /// changes nothing then. Takes about 1 µs an entity, because the shapes are rotated to check them.
  void restore(const WorldState& state);
  /// Replaces the state without checking it, at the cost of a copy. For rollback: `state` must come from save() of this
  /// world or of one with equal map parts and shapes, or accepts() must have accepted it. The behaviour is undefined
  /// for other states. Asserts that it is accepted, in builds with assertions.
  void restoreUnchecked(const WorldState& state);
  /// Hash of the state, identical on every platform.
  std::uint64_t hash() const { return state_.hash(); }
  /// Whether the worlds have equal states, map parts and shapes: then equal calls with equal rules keep them equal. Map
  /// parts and shapes are compared by content, so that two worlds built alike are equal; those that the worlds share
  /// are not compared again. Rules are not part of a world and are not compared.
  friend bool operator==(const World& a, const World& b) { return a.state_ == b.state_ && a.isBuiltLike(b); }

  const Geometry& geometry() const { return *geometry_; }
  /// By index. The state of a destroyed entity is EntityState().
  std::span<const EntityState> entities() const { return state_.entities; }
  /// Whether the entity exists: its index was given to an entity that is not destroyed.
  bool exists(std::uint32_t entity) const {
    return entity < state_.entities.size() && !WorldState::isDestroyed(state_.generationOf(entity));
  }
  /// Whether the entity exists and has this generation.
  bool exists(EntityId id) const {
    return id.index < state_.entities.size() && state_.generationOf(id.index) == id.generation &&
           !WorldState::isDestroyed(id.generation);
  }
  /// The id of the entity.
  EntityId idOf(std::uint32_t entity) const { return {checked(entity), state_.generationOf(entity)}; }
  /// The further instances of the entity (all but its home instance).
  std::span<const InstanceState> instancesOf(std::uint32_t entity) const;
  /// Position of a further instance of the entity, in the frame of the instance's part.
  Point positionOf(std::uint32_t entity, const InstanceState& instance) const;
  /// The unrotated shape of the entity.
  const Convex& shapeOf(std::uint32_t entity) const;
  /// The shape of the entity rotated by `angle`, from a cache. Null when the rotated shape is degenerate. Valid until
  /// the world is solved or assigned to.
  const Convex* rotatedShapeOf(std::uint32_t entity, Angle angle);
  /// All instances of the entity, home first.
  std::vector<InstanceView> view(std::uint32_t entity) const;

  /// Whether MapPart::insert would place a new entity of this shape in the part, by these rules. They are asked with an
  /// entity of a copy of this world, to which it was added. Takes as long as that copy: to ask often, ask for an entity
  /// that exists (MapPart::canPlace). False and exceptions as there.
  [[nodiscard]] bool canPlace(std::uint32_t part, const Convex& shape, Point origin, Angle angle, Rules& rules) const;

  /// Registers a shape and returns its index. Equal shapes get the same index. A state can be restored only when its
  /// shapes are registered in the same order.
  std::uint32_t addShape(const Convex& shape);
  /// The first warp that no entity can pass, because its target is not initialised or has no reverse warp, as an
  /// English sentence; nothing when there is none. Such a warp blocks like a wall, and no function refuses it: ask once
  /// after the last MapPart::initialize. Takes time for all warps of the map.
  std::optional<std::string> mapFault() const;
  /// Validates a state of unknown origin: all indices exist, all values are in range, instance ids are unique, no shape
  /// is degenerate at its rotation, and every further instance either has no parent or is reached from its parent by
  /// the named warp. Returns the first fault as an English sentence that names the field, or nothing when there is
  /// none. Tests neither whether shapes overlap segments nor whether the state comes from a world with the same map.
  std::optional<std::string> fault(const WorldState& state) const;
  /// Whether `state` has no fault.
  bool accepts(const WorldState& state) const { return !fault(state); }
  /// Erases the entity from all parts; its contacts end (see Rules). It still exists, in no part. No effect when it is
  /// in none. MapPart::erase does this for one part.
  void erase(std::uint32_t entity);
  /// Destroys the entity: erases it from all parts, which ends its contacts, and frees its index. Handles of it are
  /// refused from then on. The next new entity gets the lowest free index, so equal calls still give equal states.
  void destroy(std::uint32_t entity);

 private:
  friend class Entity;
  friend class MapPart;

  // Returns `entity`, or refuses it when there is no such entity.
  std::uint32_t checked(std::uint32_t entity) const {
    if (!exists(entity)) refuse(entity);
    return entity;
  }
  // As above, for the entity of a handle.
  std::uint32_t checked(EntityId id) const {
    if (!exists(id)) refuse(id);
    return id.index;
  }
  [[noreturn]] void refuse(std::uint32_t entity) const;
  [[noreturn]] void refuse(EntityId id) const;
  WorldLink& link();
  void requireNoStep() const;
  void requireNoCallback() const;
  Rules& rules() const;
  bool isBuiltLike(const World& other) const;
  std::uint32_t add(const Convex& shape);
  void insert(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  bool canPlace(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  bool isIn(std::uint32_t entity, std::uint32_t part) const;
  void erase(std::uint32_t entity, std::uint32_t part);
  struct Placed;
  Placed placedOf(std::uint32_t entity) const;
  static void eraseFrom(Placed& placed, std::uint32_t part);
  static void promoteFirst(Placed& placed);
  const char* insertInto(Placed& placed, std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  std::uint16_t place(Placed& placed, std::uint32_t part, Point origin, Angle angle) const;
  bool insertReached(std::uint32_t entity, Placed& placed, std::uint16_t inserted);
  void replace(std::uint32_t entity, const Placed& placed);
  void replaceSilently(std::uint32_t entity, const Placed& placed);
  void requireNotMoved(const StepScratch& scratch) const;
  std::vector<SegmentRef> contactsOf(std::uint32_t entity, Placed placed);
  void moveAll(StepObserver* observer);
  void move(std::uint32_t entity, std::span<const InstanceState> further, StepObserver* observer);
  EntityCache& load(std::uint32_t entity, const EntityState& state, std::span<const InstanceState> further);
  StepState beginStep(std::uint32_t entity, EntityState& state, StepObserver* observer);
  void deliverEvents();

  std::shared_ptr<const Geometry> geometry_;
  std::vector<std::shared_ptr<const Convex>> shapes_;
  WorldState state_;
  Rules* rules_;
  Rules* rulesOfCall_ = nullptr;          // instead of rules_, while a call lasts that was given them
  std::unique_ptr<StepScratch> scratch_;  // derived state, not saved
  std::unique_ptr<WorldLink> link_;       // null until the first handle is made
};

}  // namespace platon
