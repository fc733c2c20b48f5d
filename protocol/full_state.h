#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/game/input.h"

namespace platon {

/// All that a client needs to join a round in progress: the payload of the `StateChunk` messages.
struct FullState {
  std::vector<Input> held;         ///< input of each slot in the last tick; later changes are relative to it
  std::vector<std::uint8_t> game;  ///< result of `Game::save`

  friend bool operator==(const FullState&, const FullState&) = default;
};

std::vector<std::uint8_t> encode(const FullState& state);
/// Returns nothing if the bytes are malformed. `game` is not checked: `Game::restore` does that.
std::optional<FullState> decodeFullState(std::span<const std::uint8_t> bytes);

}  // namespace platon
