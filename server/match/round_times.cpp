#include "server/match/round_times.h"

#include <algorithm>

#include "platon/game/game.h"
#include "server/match/roster.h"

namespace platon {

void RoundTimes::startRound() {
  uncountedAt_ = sharedAt_ = 0;
  arrived_.clear();
  bestIsNew_ = false;
}

bool RoundTimes::note(const Game& game, const PlayerNames& names, std::size_t players) {
  noteAttempts(game, players);
  const bool isBest = offerFinishes(game, names);
  arrived_.assign(game.slots(), false);
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) arrived_[slot] = game.player(slot).arrived != 0;
  bestIsNew_ = bestIsNew_ || isBest;
  return isBest;
}

// What attempts that run in this tick are worth.
void RoundTimes::noteAttempts(const Game& game, std::size_t players) {
  if (!counts_) uncountedAt_ = game.tick();
  if (players > std::max(1u, game.level().players)) sharedAt_ = game.tick();
}

// Offers the times of those who have reached the goal in this tick.
bool RoundTimes::offerFinishes(const Game& game, const PlayerNames& names) {
  bool isBest = false;
  for (std::uint32_t slot = 0; keeper_ != nullptr && slot < game.slots(); ++slot) {
    const PlayerState& player = game.player(slot);
    if (!arrives(game, slot) || player.startedAt <= uncountedAt_ || names.isFree(slot)) continue;
    const BestTime time{game.tick() - player.startedAt + 1, names.shown(slot)};
    if (time.ticks > kMaxBestTicks) continue;
    const bool isKept = std::find(kept_.begin(), kept_.end(), slot) != kept_.end();
    const bool lasts = !keepsTimesOfOne_ || (isKept && player.startedAt > sharedAt_);
    isBest = keeper_->offer(game.level().hash, time, lasts) || isBest;
  }
  return isBest;
}

// Whether a player has reached the goal in the last tick.
bool RoundTimes::arrives(const Game& game, std::uint32_t slot) const {
  return game.player(slot).arrived != 0 && (slot >= arrived_.size() || !arrived_[slot]);
}

std::optional<LevelBest> RoundTimes::best(const Level& level) const {
  const auto best = keeper_ != nullptr ? keeper_->best(level.hash) : std::nullopt;
  return best ? std::optional(LevelBest{best->ticks, best->name, bestIsNew_}) : std::nullopt;
}

}  // namespace platon
