#pragma once

#include <bit>
#include <cstdint>

#include "platon/game/player.h"

namespace platon {

/// Counts for how long a player has not touched ground. A player that falls round the solid for ever, or has come to
/// rest where it cannot stand, must be told how to return.
class AirTime {
 public:
  static constexpr std::uint32_t kHintTicks = 240;  ///< without ground, after which a player needs the hint: 4 s
  static constexpr int kHintFaces = 3;              ///< that a player has been on since it last stood: likewise

  /// `player` is the state after `ticks` ticks, and `face` the one that it is on. Ignored unless `ticks` exceeds that
  /// of all earlier calls: replaying ticks counts none twice.
  void observe(std::uint32_t ticks, const PlayerState& player, std::uint32_t face);

  /// Ticks since the player last stood, was absent, or pressed restart.
  std::uint32_t ticks() const { return newest_ - grounded_; }
  /// A jump may lead over an edge and back, but who comes to a third face does not stand soon.
  bool needsHint() const { return ticks() >= kHintTicks || std::popcount(faces_) >= kHintFaces; }

 private:
  std::uint32_t newest_ = 0;    // last tick observed
  std::uint32_t grounded_ = 0;  // last tick from which time is counted
  std::uint32_t faces_ = 0;     // bit F: on face F since then
};

}  // namespace platon
