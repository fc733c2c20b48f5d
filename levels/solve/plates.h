#pragma once

#include <cstdint>

#include "platon/game/game.h"

namespace platon {

/// Whether this player stands on this plate, with its centre over the same face.
bool standsOn(const Game& game, std::uint32_t slot, const Element& plate);

}  // namespace platon
