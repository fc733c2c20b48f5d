#include "client/time/slewing_clock.h"

#include <algorithm>
#include <cmath>

namespace platon {

SlewingClock::SlewingClock(double tick, Time now, double maxSlew, double jumpTicks)
    : now_(now), tick_(tick), lead_(tick - toTicks(now)), target_(lead_), maxSlew_(maxSlew), jumpTicks_(jumpTicks) {}

bool SlewingClock::update(Time now, bool atOnce) {
  const double maxChange = maxSlew_ * toTicks(now - now_);
  const double missing = target_ - lead_;
  const bool jumps = atOnce || std::abs(missing) > jumpTicks_;
  lead_ += jumps ? missing : std::clamp(missing, -maxChange, maxChange);
  jumps_ += jumps ? 1 : 0;
  now_ = now;
  tick_ = toTicks(now) + lead_;
  return jumps;
}

void SlewingClock::holdAt(double tick) {
  if (tick_ <= tick) return;
  lead_ -= tick_ - tick;
  tick_ = tick;
}

}  // namespace platon
