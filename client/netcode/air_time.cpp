#include "client/netcode/air_time.h"

#include "platon/game/input.h"

namespace platon {

void AirTime::observe(std::uint32_t ticks, const PlayerState& player, std::uint32_t face) {
  if (ticks <= newest_) return;
  const bool first = newest_ == 0;
  newest_ = ticks;
  const bool restarts = (player.held & Input::kRestart) != 0;
  if (first || player.present == 0 || player.ground != Point() || restarts) {
    grounded_ = ticks;
    faces_ = 0;
  }
  faces_ |= std::uint32_t{1} << face;
}

}  // namespace platon
