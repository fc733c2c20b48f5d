#pragma once

#include <vector>

#include "platon/physics/entity_state.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"

namespace platon {

/// The simple case of a step, which is the usual one: a body that does not turn, of one instance, moves by its velocity
/// and nothing is near its path. It goes straight to the lattice point nearest to its ideal place, without an event.
/// Changes the state and its `instances`, which have been loaded from it, exactly as EntityStep would, and returns
/// true; in every other case changes neither, and returns false. `regions` are those of the entity.
bool flyFreely(EntityState& state, Instances& instances, std::vector<Region>& regions, Region::Work& work);

}  // namespace platon
