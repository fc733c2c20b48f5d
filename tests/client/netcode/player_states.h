#pragma once

#include "platon/game/player.h"

namespace platon {

inline PlayerState falling() {
  PlayerState player;
  player.present = 1;
  return player;
}

inline PlayerState standing() {
  PlayerState player = falling();
  player.ground = {0, PlayerState::kUnit};
  return player;
}

}  // namespace platon
