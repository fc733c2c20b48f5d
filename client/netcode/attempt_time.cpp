#include "client/netcode/attempt_time.h"

namespace platon {

void AttemptTime::observe(std::uint32_t ticks, const PlayerState& player) {
  if (ticks <= newest_) return;
  newest_ = ticks;
  const bool arrives = player.arrived != 0 && !arrived_;
  const bool improves = player.finishTicks != best_;
  arrived_ = player.arrived != 0;
  best_ = player.finishTicks;
  if (player.startedAt == 0) {
    attempt_ = 0;
  } else if (arrives && improves) {
    attempt_ = player.finishTicks;  // exact also if the arrival was predicted too late
  } else if (arrives || !arrived_) {
    attempt_ = ticks - player.startedAt + 1;
  }
}

}  // namespace platon
