#pragma once

#include <cstdint>

#include "levels/drawing/colour.h"

namespace platon {

/// Colour of a face: dark, so that segments stand out, and different from faces of nearby indices.
Colour faceColour(int face);

/// Colour of a player: bright, and different from players of nearby slots.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
