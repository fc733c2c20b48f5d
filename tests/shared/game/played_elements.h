#pragma once

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon {

/// A floor over the whole width of a face of cubeLevel.
inline const std::string kFlat = "-240 -200 240 -200\n";
/// The height at which a player stands on it.
inline constexpr std::int32_t kStanding = units(-200) + kPlayerApothem;

/// A game on this floor and these lines, whose player has come to rest.
inline PlayedGame playedOn(const std::string& lines, const std::string& start = "0 0 -180 0") {
  PlayedGame played(cubeLevel(start, {kFlat + lines}));
  played.run(30, kNone);
  return played;
}

}  // namespace platon
