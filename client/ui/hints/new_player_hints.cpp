#include "client/ui/hints/new_player_hints.h"

namespace platon {

void NewPlayerHints::observe(const Game& game, std::uint32_t slot, Settings& settings) {
  if (settings.firstKeys == keys_.done()) keys_ = FirstKeys(!settings.firstKeys);  // turned on again, or off
  if (slot >= game.slots() || game.player(slot).present == 0) return;
  const PlayerState player = game.player(slot);
  keys_.observe(player, game.world().entities()[slot].part);
  settings.firstKeys = !keys_.done();
  if (keys_.hint(KeyHints()).empty()) elements_.observe(player, game.level().elements, settings.untold);
}

std::string NewPlayerHints::hint(const KeyHints& keys) const {
  const std::string ofKeys = keys_.hint(keys);
  return ofKeys.empty() ? std::string(elements_.hint()) : ofKeys;
}

}  // namespace platon
