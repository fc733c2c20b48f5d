#include "server/match/transfer_cache.h"

#include <algorithm>

#include "protocol/full_state.h"

namespace platon {

Transfer TransferCache::level(const LevelPointer& level) {
  const Transfer fresh(level);
  const auto known = std::find_if(levels_.begin(), levels_.end(),
                                  [&fresh](const Transfer& transfer) { return transfer.isSameLevel(fresh); });
  if (known != levels_.end()) return *known;
  if (levels_.size() == kLevels) levels_.erase(levels_.begin());
  return levels_.emplace_back(fresh);
}

Transfer TransferCache::state(std::uint32_t round, const TickHistory& history, const Game& game, std::uint8_t sync) {
  const std::pair at{round, history.end()};
  if (stateAt_ != at) {
    stateAt_ = at;
    state_ = encode(FullState{history.held(), game.save()});
    states_.clear();
  }
  const auto known =
      std::find_if(states_.begin(), states_.end(), [sync](const auto& entry) { return entry.first == sync; });
  if (known != states_.end()) return known->second;
  return states_.emplace_back(sync, Transfer(round, history.end(), sync, state_)).second;
}

}  // namespace platon
