#pragma once

#include <optional>
#include <vector>

#include "client/audio/cue.h"
#include "platon/game/solid.h"

namespace platon {

/// What is to be heard from one frame of the game to the next.
struct SoundFrame {
  std::vector<Cue> cues{};
  double roll = 0;                   ///< speed of the local player on the ground, 0 … 1: a run
  bool celebrates = false;           ///< the local player has just reached the goal
  std::optional<SolidKind> solid{};  ///< whose pad is played; nothing: none
};

}  // namespace platon
