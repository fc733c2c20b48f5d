#pragma once

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon {

inline constexpr std::int32_t kApothem = kPlayerApothem;
inline constexpr std::int32_t kGravity = 300;

/// A floor over the whole first face.
inline const std::string kFlatFloor = "-240 -200 240 -200";

/// A player that has come to rest on the first face, with these lines, of a hexahedron.
inline PlayedGame standingOn(const std::string& lines, const std::string& start = "0 0 -180 0") {
  PlayedGame played(cubeLevel(start, {lines}));
  played.run(60, kNone);
  return played;
}

}  // namespace platon
