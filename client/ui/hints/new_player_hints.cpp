#include "client/ui/hints/new_player_hints.h"

namespace platon {

void NewPlayerHints::observe(const Game& game, std::uint32_t slot, Settings& settings) {
  if (settings.firstKeys == keys_.done()) keys_ = FirstKeys(!settings.firstKeys);  // turned on again, or off
  if (slot >= game.slots() || game.player(slot).present == 0) return;
  const PlayerState player = game.player(slot);
  const EntityState& ball = game.world().entities()[slot];
  keys_.observe(player, ball.part);
  settings.firstKeys = !keys_.done();
  if (keys_.done()) elements_.observe(player, ball, game.level().elements, settings.untold);
}

std::string NewPlayerHints::hint(const KeyHints& keys) const {
  return keys_.done() ? std::string(elements_.hint()) : keys_.hint(keys);
}

}  // namespace platon
