#pragma once

#include <cstdint>

#include "levels/drawing/colour.h"

namespace platon {

/// Colour of a player: bright, and different from players of nearby slots.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
