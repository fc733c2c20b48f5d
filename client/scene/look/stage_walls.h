#pragma once

#include <span>
#include <vector>

#include "client/scene/look/edge_meetings.h"
#include "client/scene/look/wall.h"
#include "client/scene/stage_model.h"

namespace platon {

/// The walls of the segments without a word, by face.
std::vector<std::vector<Wall>> wallsOf(const StageModel& stage);

/// The walls of the elements, by face: thin low ledges for `oneway`, blocks for `up`, a zigzag for `hazard`, two rails
/// for `door`, a wall and a bar for `plate`. `up` and `door` are low while they are open, the bar while it is pressed.
/// `shares`: by Level::elements, how active each one looks, 0 … 1; the leaves of a door slide meanwhile.
std::vector<std::vector<Wall>> elementWallsOf(const StageModel& stage, std::span<const double> shares);

/// Where the walls of all segments that can block meet the edges. `stage` must outlive the result.
EdgeMeetings edgeMeetingsOf(const StageModel& stage);

}  // namespace platon
