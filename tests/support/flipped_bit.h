#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platon/game/game.h"

namespace platon {

/// The saved state of `game` with one bit flipped, such that it can be restored and differs only in `owner`'s `field`.
/// Flips the first of several such bits. Throws std::logic_error if there is none.
std::vector<std::uint8_t> flippedBit(const Game& game, const std::string& owner, const std::string& field);

}  // namespace platon
