#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/game/input.h"

namespace platon {

/// All that a client needs to take up a round in the middle: what the pieces of `StateChunk` make together.
struct FullState {
  std::vector<Input> held;         ///< what each slot did in the last tick, the base of the next changes
  std::vector<std::uint8_t> game;  ///< as `Game::save` gives it

  friend bool operator==(const FullState&, const FullState&) = default;
};

std::vector<std::uint8_t> encode(const FullState& state);
/// Nothing when the bytes cannot come from `encode`; `game` is still to be checked by `Game::restore`.
std::optional<FullState> decodeFullState(std::span<const std::uint8_t> bytes);

}  // namespace platon
