#pragma once

#include <cstdint>

#include "platon/game/game.h"

namespace platon {

/// Whether this player uses this element: its key is taken, by whomever; the player stands on the plate, with its
/// centre over the same face; or it would return to the checkpoint. Other elements have no use.
bool uses(const Game& game, std::uint32_t slot, const Element& element);

}  // namespace platon
