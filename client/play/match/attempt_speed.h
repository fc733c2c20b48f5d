#pragma once

#include <algorithm>
#include <cstdint>

#include "platon/game/player.h"

namespace platon {

/// The least speed at which the game has run during the present attempt of a player, up to the goal.
class AttemptSpeed {
 public:
  /// The game of this round has run at this speed, 0.5 … 1, since the last call; `player` is its present state.
  void observe(std::uint32_t round, const PlayerState& player, double speed) {
    const bool begins = player.startedAt == 0 || player.startedAt != startedAt_ || round != round_;
    if (begins) {
      least_ = speed;
    } else if (player.arrived == 0) {
      least_ = std::min(least_, speed);
    }
    round_ = round;
    startedAt_ = player.startedAt;
  }

  double least() const { return least_; }

 private:
  std::uint32_t round_ = 0;
  std::uint32_t startedAt_ = 0;  // as PlayerState
  double least_ = 1;
};

}  // namespace platon
