#pragma once

#include <cstddef>
#include <vector>

#include "shared/physics/entity_step.h"
#include "shared/physics/region.h"
#include "shared/physics/rest.h"
#include "shared/physics/shape_cache.h"

namespace platon {

/// Derived state of a world: caches and buffers. Not saved or copied; influences speed only.
class StepScratch {
 public:
  /// Ensures that there is an element for each of this many entities.
  void provideFor(std::size_t entities) {
    if (steps.size() >= entities) return;
    regions.resize(entities);
    rests.resize(entities);
    steps.resize(entities);
  }
  /// Discards everything that points to cached shapes.
  void forgetShapes() {
    regions.clear();
    steps.clear();
  }

  ShapeCache shapes;
  std::vector<std::vector<Region>> regions;  ///< by entity
  Region::Work work;
  std::vector<Rest> rests;             ///< by entity
  std::vector<EntityStep> steps;       ///< by entity
  std::vector<InstanceState> further;  ///< further instances of all entities after the step
};

}  // namespace platon
