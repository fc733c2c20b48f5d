#pragma once

#include <vector>

#include "shared/physics/entity_step.h"
#include "shared/physics/region.h"
#include "shared/physics/rest.h"
#include "shared/physics/shape_cache.h"

namespace platon {

/// Derived state of a world: rebuilt when missing, never saved, without influence on any result.
class StepScratch {
 public:
  ShapeCache shapes;
  std::vector<std::vector<Region>> regions;   ///< by entity
  std::vector<Rest> rests;                    ///< by entity
  EntityStep step;
  std::vector<InstanceState> further;         ///< the instances of all entities after the step
};

}  // namespace platon
