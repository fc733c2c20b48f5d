#include "client/netcode/player_flashes.h"

#include <algorithm>

namespace platon {

void PlayerFlashes::observe(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player) {
  if (slot >= players_.size()) players_.resize(slot + 1);
  Observed& observed = players_[slot];
  if (ticks <= observed.newest) return;
  const bool first = observed.newest == 0;
  observed.newest = ticks;
  const bool stands = player.ground != Point();
  const bool lands = stands && observed.airTicks >= kMinAirTicks;
  // A player that had finished before the first observation does not flash.
  const bool finishes = !first && player.finished() && !observed.finished;
  observed.airTicks = stands || player.present == 0 ? 0 : observed.airTicks + 1;
  observed.finished = player.finished();
  if (lands || finishes) observed.flashes[observed.count++ % observed.flashes.size()] = ticks;
}

double PlayerFlashes::brightness(std::uint32_t slot, double tick) const {
  if (slot >= players_.size()) return 0;
  const Observed& observed = players_[slot];
  double brightest = 0;
  for (std::size_t i = 0; i < std::min(observed.count, observed.flashes.size()); ++i) {
    const double age = tick - observed.flashes[i];
    if (age >= 0) brightest = std::max(brightest, 1 - age / kTicks);
  }
  return brightest;
}

}  // namespace platon
