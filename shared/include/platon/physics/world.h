#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/rules.h"
#include "platon/physics/step_observer.h"

namespace platon {

class StepScratch;

/// The basic state of a world: all that decides its future besides its static geometry, shapes and rules.
struct WorldState {
  std::vector<EntityState> entities;
  std::vector<InstanceState> instances;  ///< of all entities, in their order

  friend bool operator==(const WorldState&, const WorldState&) = default;
};

/// The collection of entities and map parts that interact. A value: copies share static geometry and have a state of
/// their own; the same state and the same calls give the same bits on every machine.
class World {
 public:
  World();
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// The rules that `solve()` calls; they must outlive the last call.
  void setRules(Rules& rules) { rules_ = &rules; }

  /// Advances all entities by one tick, in the order of their indices. `observer`, when given, is told of every leg.
  void solve(StepObserver* observer = nullptr);
  /// The same under other rules.
  void solve(Rules& rules, StepObserver* observer = nullptr);

  const WorldState& save() const { return state_; }
  /// The state must come from a world with the same parts and shapes.
  void restore(const WorldState& state);
  /// Of the state, the same on every machine.
  std::uint64_t hash() const;
  friend bool operator==(const World& a, const World& b) { return a.state_ == b.state_; }

  const Geometry& geometry() const { return *geometry_; }
  std::span<const EntityState> entities() const { return state_.entities; }
  /// The entity's instances beyond its home.
  std::span<const InstanceState> instancesOf(std::uint32_t entity) const;
  /// Where an instance of the entity beyond its home stands, in its own part's frame.
  Point positionOf(std::uint32_t entity, const InstanceState& instance) const;
  const Convex& shapeOf(std::uint32_t entity) const;
  /// The same turned by `angle`, made once: valid until the world is solved or assigned to. Null when it degenerates.
  const Convex* turnedShapeOf(std::uint32_t entity, Angle angle);
  /// Every instance as it stands, home first.
  std::vector<InstanceView> view(std::uint32_t entity) const;

  /// Makes a shape known; an entity may be made of it, or of a state that was saved with it. Returns its index, the
  /// same for equal shapes.
  std::uint32_t addShape(const Convex& shape);
  /// Whether `state` could have been saved by a world with these parts and shapes: no index leads astray, all
  /// coordinates are in range, and every instance hangs on another by a warp that leads there or was placed by hand.
  bool accepts(const WorldState& state) const;
  /// Takes the entity out of all parts.
  void remove(std::uint32_t entity);

 private:
  friend class Entity;
  friend class MapPart;

  std::uint32_t add(const Convex& shape);
  void insert(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  bool isIn(std::uint32_t entity, std::uint32_t part) const;
  void erase(std::uint32_t entity, std::uint32_t part);
  static void promoteFirst(EntityState& state, std::vector<InstanceState>& further);
  void placeHome(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  void placeFurther(std::uint32_t entity, std::uint32_t part, Point origin, Angle angle);
  bool settle(std::uint32_t entity);
  void move(std::uint32_t entity, std::span<const InstanceState> further, Rules& rules, StepObserver* observer);
  void beginStep(std::uint32_t entity, std::span<const InstanceState> further, Rules& rules, StepObserver* observer);
  template <class Edit>
  void replaceInstances(std::uint32_t entity, Edit&& edit);

  std::shared_ptr<const Geometry> geometry_;
  std::vector<std::shared_ptr<const Convex>> shapes_;
  WorldState state_;
  Rules* rules_;
  std::unique_ptr<StepScratch> scratch_;  // derived
};

}  // namespace platon
