#pragma once

#include <memory>
#include <string>

#include "tests/shared/game/played_game.h"

namespace platon {

/// A door between start and goal, and its key on the other side. Somewhere 400 segments are in reach, so about 1800
/// ticks of 256 slots can be played again.
inline std::shared_ptr<const Level> crowdedDoorLevel() {
  std::string crowd;
  for (int i = 0; i < 400; ++i) {
    const std::string end = std::to_string(i % 20) + " " + std::to_string(i / 20);
    crowd.append(end).append(" ").append(end).append(".5\n");
  }
  return cubeLevel("0 0 -180 0",
                   {"-240 -200 240 -200\n60 -200 60 200 door 1\n-60 -200 -60 -150 key 1", "", "", "", "", crowd},
                   "0 150 -190");
}

}  // namespace platon
