#pragma once

#include <cstdint>

#include "platon/game/player.h"

namespace platon {

/// The time of a player's present attempt: it runs from the first input and stops at the goal. The game keeps only the
/// shortest time of a round; this class also remembers that of a slower attempt.
class AttemptTime {
 public:
  /// `player` is the state after `ticks` ticks. Ignored unless `ticks` exceeds that of all earlier calls.
  void observe(std::uint32_t ticks, const PlayerState& player);

  /// 0 before the first input of the attempt.
  std::uint32_t ticks() const { return attempt_; }
  /// Whether the player has touched the goal in this attempt: the time stands still.
  bool arrived() const { return arrived_; }

 private:
  std::uint32_t newest_ = 0;  // last tick observed
  std::uint32_t attempt_ = 0;
  std::uint32_t best_ = 0;  // PlayerState::finishTicks at the last observation
  bool arrived_ = false;
};

}  // namespace platon
