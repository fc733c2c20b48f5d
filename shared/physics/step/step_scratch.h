#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "platon/physics/entity_state.h"
#include "platon/physics/rules.h"
#include "shared/physics/collider.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"
#include "shared/physics/shape_cache.h"
#include "shared/physics/step/step_events.h"
#include "shared/physics/step/step_state.h"

namespace platon {

/// The rules of a world on which setRules was not called.
class DefaultRules : public Rules {
 public:
  Scope scope() const override { return Scope::kContacts; }
};

/// Records a step, without rotation, that did not change its entity. While the state of the entity is the same, the
/// next step would have the same result, so it is replaced by repeating the events. Derived state; influences speed
/// only. Valid while the same segments block and no map part is added: so the step must not have asked Rules::pierce.
class Rest {
 public:
  /// Whether a step from this state, with these rules and their scope, was recorded as changing nothing.
  bool matches(const EntityState& state, std::span<const InstanceState> further, const Rules& rules,
               Rules::Scope scope) const {
    return known_ && scope == scope_ && state == state_ &&
           std::equal(further.begin(), further.end(), further_.begin(), further_.end()) &&
           (solid_.empty() || areSolid(rules));
  }
  /// Adds the events of the recorded step to `events`, as those of `entity`, and its instances to `further`.
  void repeat(StepEvents& events, EntityId entity, std::vector<InstanceState>& further) const;

  /// Records a step from `before` and `further` to `after` and `furtherAfter` with these events, if it changed nothing.
  /// Otherwise forgets the previous record. `collider` is that of the step.
  void record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
              std::span<const InstanceState> furtherAfter, std::span<const StepEvents::Event> events,
              const Collider& collider);
  void forget() { known_ = false; }

 private:
  // Whether all that blocked in the step blocks with these rules, too.
  bool areSolid(const Rules& rules) const;

  bool known_ = false;
  Rules::Scope scope_ = Rules::Scope::kContacts;
  std::vector<Collider::PartSegment> solid_;  // with Scope::kSegments: what blocked
  EntityState state_;
  std::vector<InstanceState> further_;
  std::vector<StepEvents::Event> events_;
};

inline void Rest::repeat(StepEvents& events, EntityId entity, std::vector<InstanceState>& further) const {
  events.add(events_, entity);
  further.insert(further.end(), further_.begin(), further_.end());
}

inline bool Rest::areSolid(const Rules& rules) const {
  return std::none_of(solid_.begin(), solid_.end(), [&](const Collider::PartSegment& segment) {
    return rules.mayPierce(segment.part, segment.index);
  });
}

inline void Rest::record(const EntityState& before, std::span<const InstanceState> further, const EntityState& after,
                         std::span<const InstanceState> furtherAfter, std::span<const StepEvents::Event> events,
                         const Collider& collider) {
  known_ = !collider.asksRules() && before == after &&
           std::equal(further.begin(), further.end(), furtherAfter.begin(), furtherAfter.end());
  if (!known_) return;
  scope_ = collider.scope();
  solid_ = collider.solid();
  state_ = after;
  further_.assign(further.begin(), further.end());
  events_.assign(events.begin(), events.end());
}

/// What is kept of one entity between its steps.
struct EntityCache {
  Instances instances;
  std::vector<Region> regions;
  Rest rest;
  std::uint32_t touched = Collider::kNoSegment;  ///< see StepState
};

/// Derived state of a world: caches and buffers. Not saved or copied; influences speed only.
class StepScratch {
 public:
  /// Ensures that there is a cache for each of this many entities.
  void provideFor(std::size_t count) {
    if (caches.size() < count) caches.resize(count);
  }
  /// Clears the cache of shapes if it is full, and then everything that points to them.
  void trimShapes() {
    if (!shapes.trim()) return;
    for (EntityCache& cache : caches) {
      cache.instances.forget();
      for (Region& region : cache.regions) region.forgetShape();
    }
  }

  ShapeCache shapes;
  std::vector<EntityCache> caches;  ///< by entity
  Region::Work work;
  Collider collider;
  StepBuffers buffers;
  std::vector<EntityState> entities;   ///< all entities after the step
  std::vector<InstanceState> further;  ///< further instances of all entities after the step
  StepEvents events;
  DefaultRules defaults;
  bool stepping = false;  ///< a step or an insertion asks Rules::pierce: nobody may change the world
};

/// While it exists, the world may be read but not changed. Drops the events that were added, unless the step is
/// complete.
class StepGuard {
 public:
  explicit StepGuard(StepScratch& scratch) : scratch_(scratch), events_(scratch.events.size()) {
    scratch.stepping = true;
  }
  StepGuard(const StepGuard&) = delete;
  StepGuard& operator=(const StepGuard&) = delete;
  ~StepGuard() {
    scratch_.stepping = false;
    if (!complete_) scratch_.events.truncate(events_);
  }
  /// Keeps the events.
  void complete() { complete_ = true; }

 private:
  StepScratch& scratch_;
  std::size_t events_;  // number of events before
  bool complete_ = false;
};

}  // namespace platon
