// What the operator of a server does to a match.
#include <algorithm>

#include "protocol/label.h"
#include "server/match/match.h"

namespace platon {

bool Match::kick(std::uint32_t slot, const std::string& reason) {
  const auto connected =
      std::find_if(players_.begin(), players_.end(), [slot](const auto& entry) { return entry.second.slot() == slot; });
  if (connected != players_.end()) {
    outgoing_.push_back({connected->first, true, true, encode(Bye{ByeCode::kRemoved, visibleLabel(reason)})});
    remove(connected->first);
    return true;
  }
  const auto found = std::find_if(disconnected_.begin(), disconnected_.end(),
                                  [slot](const Disconnected& entry) { return entry.player.slot() == slot; });
  if (found == disconnected_.end()) return false;
  removeDisconnected(found);
  return true;
}

bool Match::mute(std::uint32_t slot, bool muted) {
  if (slot >= settings_.maxPlayers || names_.isFree(slot)) return false;
  names_.mute(slot, muted);
  return true;
}

void Match::say(const std::string& text) { sendAll(encode(Notice{visibleLabel(text)})); }

std::vector<PlayerStatus> Match::playerStatus() const {
  std::vector<PlayerStatus> all;
  const auto add = [this, &all](const MatchPlayer& player, std::optional<ClientId> client) {
    all.push_back({player.slot(), player.name(), names_.shown(player.slot()), names_.isMuted(player.slot()), client,
                   player.address(), player.missedInputs()});
  };
  for (const auto& [client, player] : players_) add(player, client);
  for (const Disconnected& entry : disconnected_) add(entry.player, std::nullopt);
  std::sort(all.begin(), all.end(), [](const PlayerStatus& a, const PlayerStatus& b) { return a.slot < b.slot; });
  return all;
}

void Match::stop(const std::string& reason, const std::string& next) {
  const SharedBytes bye = encode(Bye{ByeCode::kServerStops, visibleLabel(reason), next});
  for (const auto& [client, player] : players_) outgoing_.push_back({client, true, true, bye});
  players_.clear();
  disconnected_.clear();
  names_ = PlayerNames(settings_.maxPlayers);
  recorder_.finish(game_);
}

}  // namespace platon
