#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/game.h"
#include "platon/physics/entity_state.h"

namespace platon {

/// What is drawn of a player, as it is after some tick.
struct PlayerSnapshot {
  std::uint32_t part = 0;
  Point position;                ///< in the part's frame, subunits
  Angle angle;                   ///< up is the part's +y turned by this
  std::uint32_t finishedAt = 0;  ///< tick of the finish; 0: not finished
  bool present = false;          ///< else the rest means nothing
};

inline PlayerSnapshot snapshotOf(const EntityState& entity) {
  return {entity.part, entity.position, entity.angle, 0, entity.inserted != 0};
}

/// Not present when the slot was never used.
inline PlayerSnapshot snapshotOf(const Game& game, std::uint32_t slot) {
  if (slot >= game.slots()) return {};
  PlayerSnapshot snapshot = snapshotOf(game.world().entities()[slot]);
  const PlayerState& player = game.player(slot);
  if (player.finished != 0) snapshot.finishedAt = player.finishedAt;
  return snapshot;
}

/// A player on its way from tick to tick. It is there if it is at both.
struct InterpolatedPlayer {
  PlayerSnapshot before;
  PlayerSnapshot now;
  double fraction = 1;  ///< of the way from `before` to `now`, 0 … 1
};

/// All players by slot between one tick and the next.
struct InterpolatedPlayers {
  std::span<const PlayerSnapshot> before;
  std::span<const PlayerSnapshot> now;
  double fraction = 1;  ///< 0 … 1

  /// Not present beyond the end of either.
  InterpolatedPlayer at(std::size_t slot) const {
    if (slot >= before.size() || slot >= now.size()) return {};
    return {before[slot], now[slot], fraction};
  }
};

}  // namespace platon
