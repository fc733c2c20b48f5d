#include "client/netcode/flashes.h"

#include <algorithm>

namespace platon {

void Flashes::look(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player) {
  if (slot >= players_.size()) players_.resize(slot + 1);
  Watched& watched = players_[slot];
  if (ticks <= watched.newest) return;
  const bool known = watched.newest != 0;  // who comes late or back has not seen what was before
  watched.newest = ticks;
  const bool stands = player.ground != Point();
  const bool lands = stands && watched.airTicks >= kAirTicks;
  const bool finishes = known && player.finished != 0 && !watched.finished;
  watched.airTicks = stands || player.present == 0 ? 0 : watched.airTicks + 1;
  watched.finished = player.finished != 0;
  if (lands || finishes) watched.flashes[watched.count++ % watched.flashes.size()] = ticks;
}

double Flashes::at(std::uint32_t slot, double tick) const {
  if (slot >= players_.size()) return 0;
  const Watched& watched = players_[slot];
  double most = 0;
  for (std::size_t i = 0; i < std::min(watched.count, watched.flashes.size()); ++i) {
    const double age = tick - watched.flashes[i];
    if (age >= 0) most = std::max(most, 1 - age / kTicks);
  }
  return most;
}

}  // namespace platon
