#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platon/game/game.h"

namespace platon {

/// The saved state of `game` with one bit flipped, so that `owner`'s `field` is another and nothing else, and restoring
/// takes it; of the bits that do that the first. Throws std::logic_error when none does.
std::vector<std::uint8_t> flippedBit(const Game& game, const std::string& owner, const std::string& field);

}  // namespace platon
