#pragma once

#include <cstddef>
#include <vector>

#include "shared/physics/region.h"
#include "shared/physics/shape_cache.h"
#include "shared/physics/step/entity_step.h"
#include "shared/physics/step/rest.h"
#include "shared/physics/step/step_events.h"

namespace platon {

/// The rules of a world on which setRules was not called.
class DefaultRules : public Rules {
 public:
  Scope scope() const override { return Scope::kContacts; }
};

/// What is kept of one entity between its steps.
struct EntityCache {
  Instances instances;
  std::vector<Region> regions;
  Rest rest;
  std::uint32_t touched = Collider::kNoSegment;  ///< see EntityStep::Context
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
  EntityStep::Buffers buffers;
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
