#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "server/match/shared_bytes.h"
#include "server/match/tick_history.h"
#include "server/match/transfer.h"

namespace platon {

/// Makes transfers of levels and states. Those of the same level, and those of the same tick and number, share their
/// messages: many clients that join at once then cost little more than one.
class TransferCache {
 public:
  /// Levels whose messages are kept: the current one and the next.
  static constexpr std::size_t kLevels = 2;

  Transfer level(const LevelPointer& level);
  /// The state of `game` after the ticks of `history`, in round `round`, with the number `sync`.
  Transfer state(std::uint32_t round, const TickHistory& history, const Game& game, std::uint8_t sync);

 private:
  std::vector<Transfer> levels_;                                    // at most kLevels, newest last; none has begun
  std::optional<std::pair<std::uint32_t, std::uint32_t>> stateAt_;  // round and tick of state_
  SharedBytes state_;
  std::vector<std::pair<std::uint8_t, Transfer>> states_;  // of state_, by number; none has begun
};

}  // namespace platon
