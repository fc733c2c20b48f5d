#pragma once

#include <cstdint>

#include "platon/game/game.h"
#include "protocol/time.h"

namespace platon {

constexpr double toTicks(Time moment) { return toSeconds(moment) * kTicksPerSecond; }

/// A clock that counts ticks: 60 × real time + lead. It slews its lead slowly towards a target lead, and jumps if it is
/// too far off. A pure function of the times passed in.
class SlewingClock {
 public:
  /// Starts at `tick` at the time `now`; the target is the lead at that time. The lead changes by at most `maxSlew` ×
  /// elapsed time, and jumps when it is more than `jumpTicks` off its target.
  SlewingClock(double tick, Time now, double maxSlew, double jumpTicks);

  /// Advances to `now`, which never decreases. `atOnce`: jump to the target. Returns whether the clock jumped.
  bool update(Time now, bool atOnce = false);
  /// Sets the clock back to `tick` if it shows more, by reducing its lead.
  void holdAt(double tick);
  void setTarget(double lead) { target_ = lead; }
  double target() const { return target_; }

  double tick() const { return tick_; }
  /// `tick()` minus 60 × real time.
  double lead() const { return lead_; }
  /// Lead minus target, ticks: positive when the clock is ahead.
  double error() const { return lead_ - target_; }
  std::uint32_t jumps() const { return jumps_; }

 private:
  Time now_;
  double tick_;
  double lead_;
  double target_;
  double maxSlew_;
  double jumpTicks_;
  std::uint32_t jumps_ = 0;
};

}  // namespace platon
