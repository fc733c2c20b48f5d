#pragma once

#include <cstdint>

#include "client/time/moment.h"
#include "platon/game/game.h"

namespace platon {

constexpr double toTicks(Moment moment) { return toSeconds(moment) * kTicksPerSecond; }

/// A clock in ticks: 60 × real time plus a lead, which it brings slowly towards a target. A pure function of the times
/// it is given.
class SlewingClock {
 public:
  /// Shows `tick` at `now`, which is its target, too. Slews by at most `maxSlew` of real time; jumps when it is more
  /// than `jumpTicks` off its target.
  SlewingClock(double tick, Moment now, double maxSlew, double jumpTicks);

  /// Lets time pass; `now` never decreases. `atOnce`: reaches its target, by a jump. True when it has jumped.
  bool update(Moment now, bool atOnce = false);
  /// Stands at `tick` if it is beyond: its lead becomes less by what it has to wait.
  void holdAt(double tick);
  void setTarget(double lead) { target_ = lead; }
  double target() const { return target_; }

  double tick() const { return tick_; }
  /// Of `tick()` over 60 × real time.
  double lead() const { return lead_; }
  /// Ticks that it is ahead (positive) or behind of its target.
  double error() const { return lead_ - target_; }
  std::uint32_t jumps() const { return jumps_; }

 private:
  Moment now_;
  double tick_;
  double lead_;
  double target_;
  double maxSlew_;
  double jumpTicks_;
  std::uint32_t jumps_ = 0;
};

}  // namespace platon
