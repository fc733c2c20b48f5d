#pragma once

#include <vector>

#include "client/scene/element_states.h"
#include "client/scene/look/wall.h"
#include "client/scene/stage_model.h"

namespace platon {

/// The walls of the segments without a word, by face.
std::vector<std::vector<Wall>> wallsOf(const StageModel& stage);

/// The walls of the elements, by face: thin low ledges for `oneway`, blocks for `up`, a zigzag for `hazard`, two rails
/// for `door`, a wall and a bar for `plate`. `up` and `door` are low while they are open, the bar while it is pressed.
std::vector<std::vector<Wall>> elementWallsOf(const StageModel& stage, const ElementStates& states);

}  // namespace platon
