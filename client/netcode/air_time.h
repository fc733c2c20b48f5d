#pragma once

#include <cstdint>

#include "platon/game/player.h"

namespace platon {

/// Counts for how long a player has not touched ground. A player that falls round the solid for ever, or has come to
/// rest where it cannot stand, must be told how to return.
class AirTime {
 public:
  static constexpr std::uint32_t kHintTicks = 240;  ///< without ground, after which a player needs the hint: 4 s

  /// `player` is the state after `ticks` ticks. Ignored unless `ticks` exceeds that of all earlier calls: replaying
  /// ticks counts none twice.
  void observe(std::uint32_t ticks, const PlayerState& player);

  /// Ticks since the player last stood, was absent, or pressed restart.
  std::uint32_t ticks() const { return newest_ - grounded_; }
  bool needsHint() const { return ticks() >= kHintTicks; }

 private:
  std::uint32_t newest_ = 0;    // last tick observed
  std::uint32_t grounded_ = 0;  // last tick from which time is counted
};

}  // namespace platon
