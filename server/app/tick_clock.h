#pragma once

#include <chrono>
#include <cstdint>

#include "platon/game/game.h"
#include "server/net/time_point.h"

namespace platon {

/// Tells when the ticks of a match are due: kTicksPerSecond a second, without drift.
class TickClock {
 public:
  /// After a pause of more than this many ticks, the missed ticks are skipped.
  static constexpr std::uint64_t kMaxBehind = kTicksPerSecond / 4;

  explicit TickClock(TimePoint now) : start_(now) {}

  /// Time of the next tick.
  TimePoint next() const { return start_ + sinceStart(ticks_ + 1); }

  /// True when a tick is due at `now`; the clock then moves on to the one after it.
  bool take(TimePoint now) {
    if (now < next()) return false;
    if (now >= start_ + sinceStart(ticks_ + kMaxBehind))
      *this = TickClock(now);
    else
      ++ticks_;
    return true;
  }

 private:
  static std::chrono::nanoseconds sinceStart(std::uint64_t ticks) {
    return std::chrono::nanoseconds(ticks * 1'000'000'000 / kTicksPerSecond);
  }

  TimePoint start_;
  std::uint64_t ticks_ = 0;
};

}  // namespace platon
