#pragma once

#include <cstdint>
#include <span>

#include "platon/game/game.h"
#include "platon/game/input.h"

namespace platon {

/// Follows the confirmed game of a client, which is the server's, tick by tick. It only watches.
class ConfirmedObserver {
 public:
  virtual ~ConfirmedObserver() = default;
  /// The confirmed game is another one: at the start of a round, and after a full state of the server. `slot` is the
  /// local player's.
  virtual void began(const Game& confirmed, std::uint32_t slot) = 0;
  /// `confirmed` has been advanced by `inputs`.
  virtual void advanced(std::span<const Input> inputs, const Game& confirmed) = 0;
};

}  // namespace platon
