#pragma once

#include <glm/vec2.hpp>

#include "client/scene/element_states.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Whether no segment that blocks the local player lies across the straight way from `from` to `to` on a face: a wall,
/// a closed door, a plate or an `up` that blocks. Level units in the frame of the face. It decides nothing but what the
/// picture points out.
bool wayIsFree(const StageModel& stage, const ElementStates& states, int face, glm::dvec2 from, glm::dvec2 to);

}  // namespace platon
