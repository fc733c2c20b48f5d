#pragma once

#include <cstdint>
#include <vector>

#include "platon/physics/entity_state.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"
#include "shared/physics/step/step_state.h"

namespace platon {

/// The step of one entity. The usual one is simple: flyFreely. In all other cases, takeStep: the entity is rotated
/// first; then its displacement is used up in legs (straight moves), whose stages are those of stages.h.

/// A body that does not turn, of one instance, moves by its velocity and nothing is near its path. It goes straight to
/// the lattice point nearest to its ideal place, without an event. Changes the state and its `instances`, which have
/// been loaded from it, exactly as takeStep would, and returns true; in every other case changes neither, and returns
/// false. `regions` are those of the entity.
bool flyFreely(EntityState& state, Instances& instances, std::vector<Region>& regions, Region::Work& work);

/// Takes the step of an entity that is in a part, and appends its further instances to `further`.
void takeStep(StepState& step, std::vector<InstanceState>& further);

/// The first stage of takeStep: rotates the entity by `centidegrees`, in portions, or as far as no segment blocks it.
void rotateBy(StepState& step, std::int32_t centidegrees);
/// Adds the instances that the shape reaches at its position. Returns false when one cannot be placed.
bool insertReachedInstances(StepState& step);

}  // namespace platon
