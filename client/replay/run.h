#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platon/game/level.h"

namespace platon {

/// One attempt of a player from its first input to the goal.
struct Run {
  std::shared_ptr<const Level> level;
  std::uint32_t ticks = 0;              ///< its time, as the game counts it
  std::vector<std::uint8_t> recording;  ///< ends with the tick in which the player touches the goal
};

}  // namespace platon
