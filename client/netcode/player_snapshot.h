#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/game.h"
#include "platon/physics/entity_state.h"

namespace platon {

/// State of a player after a tick, as far as it is drawn.
struct PlayerSnapshot {
  std::uint32_t part = 0;
  Point position;                 ///< in the part's frame, subunits
  Angle angle;                    ///< up is the part's +y rotated by this angle
  std::uint32_t finishTicks = 0;  ///< shortest time to the goal in this round, in ticks; 0: not finished
  bool present = false;           ///< if false, the other fields are meaningless
};

inline PlayerSnapshot snapshotOf(const EntityState& entity) {
  return {entity.part, entity.position, entity.angle, 0, entity.inserted != 0};
}

/// A slot that was never used is not present.
inline PlayerSnapshot snapshotOf(const Game& game, std::uint32_t slot) {
  if (slot >= game.slots()) return {};
  PlayerSnapshot snapshot = snapshotOf(game.world().entities()[slot]);
  snapshot.finishTicks = game.player(slot).finishTicks;
  return snapshot;
}

/// A player between two ticks. Present only if present in both snapshots.
struct InterpolatedPlayer {
  PlayerSnapshot before;
  PlayerSnapshot now;
  double fraction = 1;  ///< 0 at `before` … 1 at `now`
};

/// All players between two ticks, by slot.
struct InterpolatedPlayers {
  std::span<const PlayerSnapshot> before;
  std::span<const PlayerSnapshot> now;
  double fraction = 1;  ///< 0 at `before` … 1 at `now`

  /// Not present if the slot is missing in `before` or `now`.
  InterpolatedPlayer at(std::size_t slot) const {
    if (slot >= before.size() || slot >= now.size()) return {};
    return {before[slot], now[slot], fraction};
  }
};

/// Seconds that so many ticks last.
constexpr double secondsOf(double ticks) { return ticks / kTicksPerSecond; }

}  // namespace platon
